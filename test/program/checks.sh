#!/usr/bin/env bash
# Copyright (c) 2026 The Flip_free_maps authors.
# This file is part of Flip_free_maps, a CGAL-style package.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s)     : The Flip_free_maps authors

# What tests of the program share: a folder to work in, and checks that are counted. The first argument of the test is the program.

set -u
program=$1
directory=$(mktemp -d) || exit 1
trap 'rm -rf "$directory"' EXIT
cd "$directory" || exit 1
failures=0
checks=0

fail()
{
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}

check()
{
  checks=$((checks + 1))
  "${@:2}" || fail "$1"
}

# expect CODE ARGUMENTS...: runs the program; every error has a line that begins with the program's name.
expect()
{
  local code=$1
  shift
  "$program" "$@" > out.txt 2> err.txt
  local got=$?
  checks=$((checks + 1))
  if [ $got -ne "$code" ]; then
    fail "exit code $got instead of $code: $* ($(head -n 1 err.txt))"
  elif [ "$code" -gt 2 ] && [ "$1" != measure ]; then
    grep -q '^flip_free_maps: ' err.txt || fail "no message: $*"
  fi
}

# value FILE KEY: a number or a string of a report.
value()
{
  sed -n "s/^ *\"$2\": *\"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}\$/\1/p" "$1" | head -n 1
}

# close A B TOLERANCE
close()
{
  awk -v a="$1" -v b="$2" -v t="$3" 'BEGIN { d = a - b; if(d < 0) d = -d; exit !(a != "" && b != "" && d <= t) }'
}

less()
{
  awk -v a="$1" -v b="$2" 'BEGIN { exit !(a != "" && b != "" && a + 0 < b + 0) }'
}

# total FILE KEY: a number or a string of a report of `unwrap`, not that of a chart.
total()
{
  sed -n "s/^  \"$2\": *\"\{0,1\}\([^\",]*\)\"\{0,1\},\{0,1\}\$/\1/p" "$1"
}

# atlas FILE OPTIONS...: unwraps a file; the atlas is without flips and overlaps, and within the unit square.
atlas()
{
  rm -f atlas.obj measured.json
  expect "${wanted:-0}" unwrap "$@" -o atlas.obj --json atlas.json
  expect 0 measure atlas.obj --json measured.json
  check "$*: no flips" test "$(value measured.json flips)" = 0
  check "$*: bijective" test "$(value measured.json bijective)" = true
  check "$*: within the unit square" awk '
    $1 == "vt" { ++n; for(k = 2; k <= 3; ++k) if($k < 0 || $k > 1) wrong = 1 }
    END { exit wrong || !n }' atlas.obj
  if [ "$(total atlas.json status)" = success ]; then
    # Each chart has the scale of the surface, which need not be the best for parts that keep the map of a whole.
    if [ "$(total atlas.json status)" = success ]; then
    # Each chart has the scale of the surface, which need not be the best for parts that keep the map of a whole.
    check "$*: energy" close "$(total atlas.json energy)" "$(value measured.json energy_of_similarity)" 1e-4
  fi
  fi
}

# The account, as the last command of a test.
finish()
{
  echo "$checks checks, $failures failed"
  [ "$failures" -eq 0 ]
}
