#!/usr/bin/env bash
# Tests the tests: applies each mutation of test/mutations.tsv to a copy of the sources, builds the test that must notice it, and runs it.
# Prints the mutations that survive; the exit code is 0 only if there are none. This takes an hour or two: each mutation costs the
# compilation of a test, and of all that it links to if the test alone does not notice. Needs Ninja.
#
# usage: test/mutation.sh [PATTERN]    only lines of the list that match the extended regular expression
#   WORK_DIR   where to copy and to build (default: build/mutation in the repository)
#   JOBS       how many files to compile at the same time (default: the number of processors)

set -euo pipefail

root="$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)"
pattern="${1:-.}"
work="${WORK_DIR:-$root/build/mutation}"
jobs="${JOBS:-$(nproc)}"

rm -rf -- "$work/source"
mkdir -p -- "$work/source"
# All is newer than what an earlier run compiled, perhaps of a mutation.
tar -C "$root" --exclude=./build --exclude=./.git -cf - . | tar -C "$work/source" -xmf -
cmake -G Ninja -S "$work/source" -B "$work/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS_RELEASE=-O1 -DFLIP_FREE_MAPS_BUILD_TESTS=ON \
      -DFLIP_FREE_MAPS_UNITY_BUILD=OFF -DFLIP_FREE_MAPS_DATA_DIR="$root/../shared/data" > /dev/null

build()
{
  cmake --build "$work/build" -j "$jobs" --target "$1" > "$work/build.log" 2>&1
}

object_of() { echo "test/CMakeFiles/$1.dir/$2.cpp.o"; }

# Compiles the test's own file only, and links it with what there is: of functions in headers the linker takes the first, the
# test's. Fails where there is no such file.
build_file()
{
  local object link
  object="$(object_of "$1" "$2")"
  cmake --build "$work/build" --target "$object" > "$work/build.log" 2>&1 || return 1
  link="$(ninja -C "$work/build" -t commands "$1" 2> /dev/null | tail -n 1)"
  (cd -- "$work/build" && eval "$link") >> "$work/build.log" 2>&1
}

run()
{
  (cd -- "$work/build" && ctest -R "^$1(\$|\\.)" --output-on-failure > "$work/test.log" 2>&1)
}

# A test of the program needs the program only.
target()
{
  case "$1" in
    program/*) echo flip_free_maps ;;
    *)         echo "${1/\//_}" ;;
  esac
}

# replace FILE TEXT REPLACEMENT: fails unless the text occurs exactly once.
replace()
{
  TEXT="$2" REPLACEMENT="$3" awk '
    { content = content $0 "\n" }
    END {
      text = ENVIRON["TEXT"]
      at = index(content, text)
      if(at == 0 || index(substr(content, at + 1), text) != 0)
        exit 1
      printf "%s%s%s", substr(content, 1, at - 1), ENVIRON["REPLACEMENT"], substr(content, at + length(text))
    }' "$1" > "$work/mutated" && cp -- "$work/mutated" "$1"
}

number=0
caught=0
declare -A passes
is_stale=no # whether there may be objects that were compiled of a mutation
while IFS=$'\t' read -r file text replacement test; do
  [[ -n "$file" && "$file" != \#* ]] || continue
  grep -qE -- "$pattern" <<< "$file $text $test" || continue
  number=$((number + 1))
  if [[ -z "$test" ]]; then
    echo "A FIELD IS EMPTY: $file: $text"
    continue
  fi
  name="$file: '$text' -> '$replacement' ($test)"
  if [[ "$is_stale" == yes ]]; then
    build "$(target "$test")" || true
    is_stale=no
  fi
  # What fails without a mutation proves nothing.
  if [[ -z "${passes[$test]:-}" ]]; then
    passes[$test]=no
    if build "$(target "$test")" && run "$test"; then
      passes[$test]=yes
    fi
  fi
  if [[ "${passes[$test]}" == no ]]; then
    echo "FAILS AS IT IS: $test"
    continue
  elif ! cp -p -- "$work/source/$file" "$work/original" || ! replace "$work/source/$file" "$text" "$replacement"; then
    echo "NOT FOUND ONCE: $name"
    continue
  elif build_file "$(target "$test")" "$test" && ! run "$test"; then
    caught=$((caught + 1))
    echo "caught: $name"
    # Nothing else was compiled with the mutation, so the file's time need not change.
    rm -f -- "$work/build/$(object_of "$(target "$test")" "$test")"
    cp -p -- "$work/original" "$work/source/$file"
    continue
  elif is_stale=yes && ! build "$(target "$test")"; then
    echo "DOES NOT COMPILE: $name"
  elif run "$test"; then
    echo "SURVIVES: $name"
  else
    caught=$((caught + 1))
    echo "caught: $name"
  fi
  cp -- "$work/original" "$work/source/$file"
done < "$root/test/mutations.tsv"

echo "$caught of $number mutations caught"
[[ "$caught" -eq "$number" ]]
