#!/usr/bin/env bash
# Installs the Debian packages that are missing for a purpose. Asks nothing and does nothing when all are there.
#
# usage: install_packages.sh tests|quickstart|python

set -euo pipefail

common=(cmake g++ make ninja-build pkg-config libcgal-dev libeigen3-dev libboost-dev libsuitesparse-dev libopenblas-dev libtbb-dev
        libcairo2-dev zlib1g-dev libtet1.5-dev libcli11-dev nlohmann-json3-dev)

python=(pybind11-dev python3-dev python3-numpy python3-pytest)

case "${1:-}" in
  tests)      packages=("${common[@]}" "${python[@]}" libopenmesh-dev python3-meshio doxygen graphviz) ;;
  quickstart) packages=("${common[@]}" libcgal-demo) ;;
  python)     packages=("${common[@]}" "${python[@]}" python3-setuptools python3-wheel python3-pip) ;;
  *)          echo "usage: $0 tests|quickstart|python" >&2; exit 2 ;;
esac

if ! command -v apt-get > /dev/null || ! command -v dpkg-query > /dev/null; then
  echo "This is no Debian system. Please make sure yourself that the equivalents of these packages are installed:"
  echo "  ${packages[*]}"
  exit 0
fi

missing=()
for package in "${packages[@]}"; do
  state="$(dpkg-query -W -f='${db:Status-Status}' "$package" 2> /dev/null || true)"
  [[ "$state" == installed* ]] || missing+=("$package")
done
if [[ ${#missing[@]} -eq 0 ]]; then
  exit 0
fi

as_root=()
if [[ "$(id -u)" -ne 0 ]]; then
  if ! command -v sudo > /dev/null; then
    echo "These packages are missing, and installing them needs root or sudo:" >&2
    echo "  apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing ${missing[*]}"
apt_get=(env DEBIAN_FRONTEND=noninteractive apt-get -y -q)
# Slim images drop /usr/share/doc, where Debian keeps the meshes of CGAL.
options=(--no-install-recommends -o "Dpkg::Options::=--path-include=/usr/share/doc/libcgal-demo/*")

"${as_root[@]}" "${apt_get[@]}" update < /dev/null || echo "The package lists could not be updated, trying with the old ones." >&2
"${as_root[@]}" "${apt_get[@]}" install "${options[@]}" "${missing[@]}" < /dev/null
