#!/usr/bin/env bash
# Does what a page says, to the letter, in an empty folder:
#   tests/plugins/follow.sh PAGE FOLDER
# A block ```LANGUAGE FILE is written to FILE, a block ```sh is run, and each line of a block ```text
# must stand in what the commands before it printed, whatever the numbers are; "..." at its end
# stands for anything.
set -euo pipefail

page="$(realpath "$1")"
rm -rf "$2"
mkdir -p "$2"
output="$(realpath "$2")/output.txt"
steps="$(realpath "$2")/steps.sh"
mkdir "$2/work"
cd "$2/work"

plain() {
  sed -E 's/[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?/#/g; s/[[:space:]]+/ /g; s/\.\.\.$//; s/^ //'
}

must_have_printed() {
  local line
  plain | while read -r line; do
    plain <"$output" | grep -qF -- "$line" || { echo "not printed: $line" >&2; return 1; }
  done
}

awk '
  /^```/ && kind == "" {
    kind = substr($1, 4)
    if (kind == "sh") print "exec >\"$output\" 2>&1"
    else if (kind == "text") print "must_have_printed <<\"END OF BLOCK\""
    else if (NF == 2) print "cat >" $2 " <<\"END OF BLOCK\""
    else { print "no name for a file: " $0 >"/dev/stderr"; exit 1 }
    next
  }
  /^```/ {
    print kind == "sh" ? "exec >&3 2>&4; cat \"$output\"" : "END OF BLOCK"
    kind = ""
    next
  }
  kind != "" { print }
' "$page" >"$steps"

exec 3>&1 4>&2
trap 'code=$?; exec >&3 2>&4; [ "$code" -eq 0 ] || { cat "$output"; echo "$page: failed" >&2; }' EXIT
source "$steps"
