#!/usr/bin/env bash
# Fails where an object of headers alone has a definition that two objects may not both have.
#
# usage: test_headers_define_nothing.sh NM LIST      (LIST: a file with the path of an object in each line)

set -euo pipefail

objects="$(grep '[.]o$' "$2")" || { echo "There are no objects in $2."; exit 1; }
symbols="$(echo "$objects" | xargs -d '\n' "$1" --extern-only --defined-only --print-file-name)"
definitions="$(echo "$symbols" | grep -E ' [ABCDGRST] ' || true)"
if [[ -n "$definitions" ]]; then
  echo "These definitions are not inline:"
  echo "$definitions" | c++filt
  exit 1
fi
