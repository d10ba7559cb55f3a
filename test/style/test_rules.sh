#!/usr/bin/env bash
# What a search for text can tell of the rules of the package: see .github/CONTRIBUTING.md.
#
# usage: test_rules.sh SOURCE_FOLDER

set -euo pipefail
cd -- "$1"

failures=0
# What is wrong, and the lines that are, if any.
refuse()
{
  if [[ -n "$2" ]]; then
    echo "$1"
    echo "$2" | sed 's/^/  /'
    failures=$((failures + 1))
  fi
}
# grep without comments, and without an error where there is nothing to find.
search()
{
  grep -rnE --include='*.h' "$1" include | grep -vE '^[^:]*:[0-9]*:[[:space:]]*//' || true
}

[[ -d include/CGAL/Flip_free_maps ]] || { echo "There is no include/CGAL/Flip_free_maps in $1."; exit 1; }

refuse "Headers print nothing:" "$(search 'std::(cout|cerr|clog|printf|puts)\b|(^|[^_[:alnum:]:.>])(printf|fprintf|puts)\(')"
refuse "Headers do not end the program:" "$(search '(^|[^_[:alnum:]:.>])(std::)?(exit|abort|terminate)\(|std::(exit|abort|terminate)\(')"
refuse "Headers do not assert; conditions that users can break have a status and a message:" "$(search '(^|[^_[:alnum:]])assert\(')"
# Within a namespace of ours, names of the named parameters of CGAL are wanted as if they were ours.
refuse "Headers import no namespace:" "$(search '^[[:space:]]*using namespace ' | grep -v 'using namespace CGAL::parameters;')"
refuse "Headers have include guards:" "$(search '#[[:space:]]*pragma once')"

wrong_guards()
{
  find include -name '*.h' | sort | xargs awk '
    function finish() { if(file != "" && found != 2) print file ": " guard }
    FNR == 1 { finish(); file = FILENAME; guard = toupper(file); sub(/^INCLUDE\//, "", guard); gsub(/[\/.]/, "_", guard); found = 0 }
    $0 == "#ifndef " guard || $0 == "#define " guard { ++found }
    END { finish() }'
}
refuse "Include guards repeat the path:" "$(wrong_guards)"

without_licence()
{
  find include examples test benchmark -type f \( -name '*.h' -o -name '*.cpp' \) -not -path '*/build*' | sort | xargs awk '
    function finish() { if(file != "" && found != 2) print file }
    FNR == 1 { finish(); file = FILENAME; found = $0 ~ /^\/\/ Copyright \(c\) / }
    FNR <= 7 && $0 == "// SPDX-License-Identifier: GPL-3.0-or-later" { ++found }
    END { finish() }'
}
refuse "Files begin with the lines of copyright and licence:" "$(without_licence)"

refuse "No tabulators, and no space at the ends of lines:" \
  "$(grep -rnE --include='*.h' --include='*.cpp' --include='*.txt' $'\t|[[:space:]]$' include examples test benchmark doc | cut -c 1-120 || true)"

[[ "$failures" -eq 0 ]]
