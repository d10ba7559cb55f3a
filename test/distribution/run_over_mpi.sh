#!/usr/bin/env bash
# Runs a program over ranks of MPI, on this machine, whether or not it has as many cores. Where nothing starts them, the test is skipped.
#
# usage: run_over_mpi.sh MPIRUN RANKS PROGRAM [ARGUMENT]...

set -euo pipefail
mpirun="$1"
ranks="$2"
shift 2

if ! command -v "$mpirun" > /dev/null; then
  echo "Skipped: there is no mpirun to start $ranks ranks with."
  exit 77
fi
options=()
if "$mpirun" --version 2>&1 | grep -q "Open MPI\|OpenRTE"; then
  options=(--oversubscribe)
  if [[ "$(id -u)" -eq 0 ]]; then
    options+=(--allow-run-as-root)
  fi
fi
exec "$mpirun" "${options[@]}" -n "$ranks" "$@"
