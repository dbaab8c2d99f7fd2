#!/bin/sh
# bench/figures in a folder of its own, with data that are made up: draws each kind of figure, writes the tables, and
# names what is wrong. figures.sh SOURCE-FOLDER
set -eu
source=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

fail() {
    echo "FAILED: $1" >&2
    exit 1
}

# expect_complaint WORD ARGUMENT...
expect_complaint() {
    word=$1
    shift
    code=0
    bench/figures/run "$@" >output 2>&1 || code=$?
    [ $code = 2 ] || fail "run $*: exit code $code"
    grep -qF -- "$word" output || fail "run $* does not name $word: $(cat output)"
}

mkdir -p "$scratch/bench" "$scratch/.ci" "$scratch/docs/figures/data"
cp -r "$source/bench/figures" "$scratch/bench/"
cd "$scratch"
printf '#!/bin/sh\n' >.ci/setup
chmod +x .ci/setup

expect_complaint "'--moon'" --moon
expect_complaint "'3.2'" 3.2
expect_complaint "'1'" 1
expect_complaint "--seconds" --seconds
expect_complaint "'soon'" --seconds soon 3.1
expect_complaint "'-1'" --sampled -1 3.1
expect_complaint "no data of figure 3.1" --draw 3.1
bench/figures/run --help | grep -q 'Figure 9.1' || fail "--help does not list the figures"

# data FIGURE ENGINE...: two worlds; engine number i is i times as fast as the first, in the stage twice that.
data() {
    figure=$1
    shift
    {
        echo "# 2 cores, Fast One"
        echo world,engine,frame_speedup_median,frame_speedup_q1,frame_speedup_q3,collision_speedup_median,collision_speedup_q1,collision_speedup_q3,dynamics_speedup_median,dynamics_speedup_q1,dynamics_speedup_q3
        for world in pioneer3at soccer; do
            i=0
            for engine in "$@"; do
                i=$((i + 1))
                echo "$world,$engine,$i,0.$i,$i.5,$((2 * i)),1,3,$((2 * i)),1,3"
            done
        done
    } >"docs/figures/data/$figure.csv"
}

data 3.1 stock ours:auto/original/concurrent ours:auto
data 10.4 stock ours:auto/decluster/concurrent ours:auto/decluster/concurrent/cells=5
data 10.5 stock ours:1 ours:2 ours:1/decluster/concurrent
data frames stock ours:0 ours:2/fast
cat >README.md <<'PAGE'
| `before` | the table | stays |
<!-- frames -->
| times as fast | bodies | old |
|---|---|---|
| `soccer`, robots | 19 | 0.1 | 0.2 |

Machine: old.
<!-- end frames -->
PAGE
{
    echo "# 2 cores, Fast One"
    echo world,engine,real_time_factor
    for world in pioneer3at bioloid create soccer; do
        for engine in stock ours:auto/decluster/concurrent ours:auto; do
            for second in 1 2 3 4 5; do echo "$world,$engine,$((10 * second))"; done
        done
    done
} >docs/figures/data/12.1.csv
{
    echo "# 2 cores, Fast One"
    echo world,engine,real_time_factor
    for world in $(sed -n 's/^samples=\(\$samples,\)\?//p' bench/figures/run | tr ',' ' '); do
        for second in 1 2 3; do echo "$world,stock,$((10 + second))"; done
        for second in 1 2 3; do echo "$world,ours:0,$((22 + 2 * second))"; done
        for second in 1 2 3; do echo "$world,ours:auto,$((34 + second))"; done
    done
} >docs/figures/data/B.1.csv
for figure in 3.1 10.4 10.5 12.1 B.1 frames; do printf '<!-- %s -->\nold\n<!-- end %s -->\n' $figure $figure; done >docs/figures.md

bench/figures/run --draw 3.1 10.4 10.5 12.1 B.1 frames >output 2>&1 || fail "run --draw: $(cat output)"
for figure in 3.1 10.4 10.5 12.1 B.1; do
    grep -q 'Fast One' "docs/figures/$figure.svg" || fail "figure $figure does not name the machine"
    grep -q 'libode8' "docs/figures/$figure.svg" || fail "figure $figure does not hold libode8"
done
cat >result.csv <<DATA
world,engine,bodies,frame_speedup_median,frame_speedup_q1,frame_speedup_q3,dynamics_speedup_median,dynamics_speedup_q1,dynamics_speedup_q3,hash
create,stock,3,1,1,1,1,1,1,00
DATA
printf 'world,engine,second,real_time_factor\ncreate,stock,1,7.5\n' >samples.csv
printf '{\n "machine": {\n  "cores": 2,\n  "processor": "Fast One"\n }\n}\n' >result.json
bench/figures/compact dynamics result.csv result.json >compact
[ "$(sed -n 1p compact)$(sed -n 3p compact)" = "# 2 cores, Fast Onecreate,stock,1,1,1,1,1,1" ] || fail "compact: $(cat compact)"
bench/figures/compact frame result.csv result.json samples.csv >compact
[ "$(sed -n 3p compact)" = create,stock,7.5 ] || fail "compact of samples: $(cat compact)"

cp docs/figures/3.1.svg once.svg
bench/figures/run --draw 3.1 >output 2>&1
cmp once.svg docs/figures/3.1.svg || fail "a figure drawn twice is not the same"

grep -qxF '| blimp | 12 ± 1 | 26 ± 2 | 36 ± 1 | 2.17 | 3.00 |' docs/figures.md || fail "no summary: $(cat docs/figures.md)"
[ "$(grep -c '| 2.17 | 3.00 |$' docs/figures.md)" = 24 ] || fail "not 24 worlds in table B.1"
grep -qxF '| frame / collision | original | ODE_MT |' docs/figures.md || fail "no titles: $(cat docs/figures.md)"
grep -qxF '| soccer | 2.00 / 4.00 | 3.00 / 6.00 |' docs/figures.md || fail "no speed-ups: $(cat docs/figures.md)"
grep -qxF '| soccer | libode8 | 30 [20, 40] | 30 ± 16 |' docs/figures.md || fail "no quantiles: $(cat docs/figures.md)"
grep -qxF '| world | one thread | `fast`, 2 threads |' docs/figures.md || fail "no titles of frames: $(cat docs/figures.md)"
grep -qxF '| `soccer` | 2 [0.2, 2.5] | 3 [0.3, 3.5] |' docs/figures.md || fail "no frames: $(cat docs/figures.md)"
grep -qxF 'Machine: 2 cores, Fast One.' docs/figures.md || fail "no machine: $(cat docs/figures.md)"
grep -qxF '| `soccer`, robots | 19 | 2.00 | 3.00 |' README.md || fail "no frames in README: $(cat README.md)"
[ "$(grep -c 'Machine: 2 cores, Fast One.' README.md)$(grep -c before README.md)" = 11 ] || fail "README: $(cat README.md)"
if grep -q old docs/figures.md; then fail "an old table is left"; fi

# A bench that measures nothing: both kinds of figures, one after the other.
mkdir -p build/release/bench
cat >build/release/bench/odemt_bench <<'BENCH'
#!/bin/sh
while [ $# -gt 0 ]; do
    case $1 in
        --worlds) worlds=$2 ;;
        --engines) engines=$2 ;;
        --csv) echo world,engine,bodies,frame_speedup_median,frame_speedup_q1,frame_speedup_q3,collision_speedup_median,collision_speedup_q1,collision_speedup_q3 >"$2"; csv=$2 ;;
        --json) cp result.json "$2" ;;
        --samples) echo world,engine,second,real_time_factor >"$2"; samples=$2 ;;
    esac
    shift
done
for world in $(echo "$worlds" | tr , ' '); do
    for engine in $(echo "$engines" | tr , ' '); do
        echo "$world,$engine,3,1,1,2,1,1,2" >>"$csv"
        for second in 1 2 3; do [ -z "${samples:-}" ] || echo "$world,$engine,$second,1$second" >>"$samples"; done
    done
done
BENCH
chmod +x build/release/bench/odemt_bench
bench/figures/run 12.1 3.1 >output 2>&1 || fail "run: $(cat output)"
[ "$(sed -n '1p;4p' docs/figures/data/12.1.csv | tr '\n' ' ')" = "# 2 cores, Fast One pioneer3at,stock,12 " ] || fail "measured: $(head -4 docs/figures/data/12.1.csv)"
[ "$(sed -n 3p docs/figures/data/3.1.csv)" = pioneer3at,stock,1,1,2,1,1,2 ] || fail "measured: $(head -4 docs/figures/data/3.1.csv)"
[ -e build/figures/3.1.json ] || fail "the whole result is not kept"

: >docs/figures.md
if bench/figures/run --draw 3.1 >output 2>&1; then fail "a document without a place for the table was taken"; fi
grep -q 'no place for figure 3.1' output || fail "the missing place is not named: $(cat output)"
echo "drawn: 4 figures"
