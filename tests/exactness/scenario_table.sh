#!/bin/sh
# Writes the table of all scenarios, a page of the site: scenario_table.sh PROGRAM PAGE
#
# PROGRAM is odemt_scenario; odemt_world_scenario is beside it. Fails if a scenario is listed twice or does not say what happens, or if a
# file of scenarios/ that adds to the catalogue has no scenario in the list.
set -eu
program=$1 page=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$program" --list >"$folder/list"
"$(dirname "$program")/odemt_world_scenario" --list >>"$folder/list"

cut -f 1 "$folder/list" | sort | uniq -d | sed 's/$/ is listed twice/' >"$folder/problems"
awk -F '\t' '$5 == "" { print $1 " does not say what happens" }' "$folder/list" >>"$folder/problems"
for file in $(grep -lE '^void add[A-Z]\w*\(Catalogue &' "$(dirname "$0")"/scenarios/*.cpp); do
    theme=$(basename "$file" .cpp)
    grep -q "^$theme/" "$folder/list" || echo "no scenario of scenarios/$theme.cpp is listed"
done >>"$folder/problems"
if [ -s "$folder/problems" ]; then
    cat "$folder/problems" >&2
    exit 1
fi

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
        print "# The scenarios of the exactness suite\n"
        print "The suite compares " count " scenarios (" NR " with both steppers) with `libode8`, bit by bit. `tests/exactness/scenario_table.sh` writes this page."
        print "\n| scenario | what happens | steppers | why it does not run in parallel |\n|---|---|---|---|"
        for (i = 1; i <= count; ++i)
            print "| `" names[i] "` | " meaning[names[i]] " | " steppers(names[i]) " | " why[names[i]] " |"
    }' "$folder/list" >"$folder/page"

mkdir -p "$(dirname "$page")"
cp "$folder/page" "$page"
sed -n 3p "$page"
