#!/usr/bin/env bash
# The page of each concept lists every class whose documentation says that it is a model, and nothing that is no class.
#
# usage: test_models.sh SOURCE_FOLDER

set -euo pipefail
cd -- "$1"

# Lines "CONCEPT CLASS": each concept named by \cgalModels{...} and the first class that is declared after it.
models="$(find include -name '*.h' | sort | xargs awk '
  FNR == 1 { concepts = "" }
  /cgalModels\{/ { concepts = $0; sub(/.*cgalModels\{/, "", concepts); sub(/\}.*/, "", concepts) }
  concepts != "" && /^(class|struct) / {
    number = split(concepts, names, /[^A-Za-z0-9_]+/)
    for(i = 1; i <= number; ++i)
      if(names[i] ~ /^[A-Z]/)
        print names[i], $2
    concepts = ""
  }')"
[[ -n "$models" ]] || { echo "No class says that it is a model."; exit 1; }

failures=0
while read -r concept class; do
  # Concepts of CGAL have no page here.
  if [[ -e "doc/Concepts/$concept.h" ]] && ! grep -qF "\\cgalHasModels{CGAL::Flip_free_maps::$class}" "doc/Concepts/$concept.h"; then
    echo "doc/Concepts/$concept.h does not list $class."
    failures=1
  fi
done <<< "$models"
for class in $(sed -n 's/.*cgalHasModels{CGAL::Flip_free_maps::\([A-Za-z0-9_]*\)}.*/\1/p' doc/Concepts/*.h | sort -u); do
  if ! grep -rqE --include='*.h' "^(class|struct) $class\b" include; then
    echo "doc/Concepts lists $class, which is no class."
    failures=1
  fi
done
exit "$failures"
