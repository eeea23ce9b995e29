# SPDX-License-Identifier: GPL-2.0-only
# What the benchmarks share: sourced, with `root` set, by run, stages and ranks.

((EUID)) || export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
machine=$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1 | tr -d ',')

fail() {
  echo "${0##*/}: $*" >&2
  exit 1
}

commit_of() { # TREE: with a + where more than the results has changed since
  local commit
  commit=$(git -C "$1" describe --always 2>/dev/null) || { echo unknown && return; }
  git -C "$1" diff --quiet HEAD -- . ':(exclude)tests/bench/results.csv' && echo "$commit" || echo "$commit+"
}

# Reads one number a line, of each turn, says their median, least and largest, and adds them to results.csv: the next
# change is held against them. The median counts, the others show the noise.
keep_result() { # SUBJECT RESOLUTION RANKS TEXT [UNIT] [COMMIT]
  local results=$root/tests/bench/results.csv
  [[ -s $results ]] || echo "machine,cores,commit,subject,resolution,ranks,what,unit,turns,median,low,high" >"$results"
  sort -g | awk -v text="$4" -v unit="${5:--}" -v file="$results" \
    -v row="${machine:-unknown},$(nproc),${6:-$(commit_of "$root")},$1,$2,$3" '{x[NR] = $1} END {
    median = x[int((NR + 1) / 2)]
    printf "%-58s median %.3f  (%.3f to %.3f)%s\n", text, median, x[1], x[NR], unit == "-" ? "" : " " unit
    gsub(/,/, ";", text)
    printf "%s,%s,%s,%d,%.4g,%.4g,%.4g\n", row, text, unit, NR, median, x[1], x[NR] >>file}'
}
