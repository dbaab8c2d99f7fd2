#!/bin/sh
# The table of scenarios in docs/exactness.md, and their numbers in its first paragraph, are those of the program
# odemt_scenario and of odemt_world_scenario beside it.
#
#   scenario_table.sh PROGRAM DOCUMENT          compares, and shows the difference
#   scenario_table.sh PROGRAM DOCUMENT --write  rewrites the document
set -eu
program=$1
document=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$program" --list >"$folder/list"
"$(dirname "$program")/odemt_world_scenario" --list >>"$folder/list"
awk -F '\t' '
    {
        name = $1; sub("/[^/]*$", "", name)
        if (!(name in runs)) names[++count] = name
        runs[name] = runs[name] == "" ? $1 : "both"
        why[name] = $2; meaning[name] = $5
    }
    function steppers(name) {
        if (runs[name] == "both") return "both"
        return runs[name] ~ /quick$/ ? "`dWorldQuickStep`" : "`dWorldStep`"
    }
    END {
        for (i = 1; i <= count; ++i)
            print "| `" names[i] "` | " meaning[names[i]] " | " steppers(names[i]) " | " why[names[i]] " |"
    }' "$folder/list" >"$folder/rows"

scenarios=$(wc -l <"$folder/rows")
runs=$(wc -l <"$folder/list")
awk -v rows="$folder/rows" -v numbers="$scenarios scenarios ($runs with both steppers)" '
    { sub(/[0-9]+ scenarios \([0-9]+ with both steppers\)/, numbers) }
    /^## / { inTable = 0 }
    /^## Scenarios/ { inTable = 1 }
    inTable && /^\| `/ { next }
    { print }
    inTable && /^\|---/ { while ((getline row <rows) > 0) print row }' "$document" >"$folder/document"

if [ "${3:-}" = --write ]; then
    cp "$folder/document" "$document"
elif ! diff -u "$document" "$folder/document"; then
    echo "rewrite it: $0 $program $document --write" >&2
    exit 1
fi
