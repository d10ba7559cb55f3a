#!/usr/bin/env bash
# The C++ files have the layout of .clang-format. Other versions than 14 lay some lines out otherwise: exit code 77, skipped.
#
# usage: test_format.sh SOURCE_FOLDER

set -euo pipefail
cd -- "$1"

tool=
for name in clang-format-14 clang-format; do
  if command -v "$name" > /dev/null && "$name" --version | grep -q ' version 14\.'; then
    tool="$name"
    break
  fi
done
if [[ -z "$tool" ]]; then
  echo "Skipped: there is no clang-format 14."
  exit 77
fi
find include examples test benchmark -type f \( -name '*.h' -o -name '*.cpp' \) -not -path '*/build*' -print0 |
  xargs -0 "$tool" --dry-run -Werror || { echo "Run $tool -i on these files."; exit 1; }
