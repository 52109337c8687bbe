#!/usr/bin/env bash
# Installs what is missing, builds ringlet, runs a scene and makes its report:
#   apps/run.sh [SCENE.json] [options of `ringlet run`]
# Without a scene it runs apps/scenes/hairball.json.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../cmake/setup.sh"

ringlet_setup page
cmake --build "$ringlet_build" --target ringlet

if [ $# -eq 0 ] || [[ "$1" == -* ]]; then
  set -- "$ringlet_root/apps/scenes/hairball.json" "$@"
fi
status=0
folder="$("$ringlet_build/apps/ringlet" run "$@")" || status=$?
[ -z "$folder" ] || echo "$folder"
if [ -d "$folder" ]; then
  if "$ringlet_build/apps/ringlet" report "$folder"; then
    echo "To look at it: open $folder/report.html in a browser, or run.pvd in ParaView."
  else
    echo "To look at it: open run.pvd of that folder in ParaView, press Apply, then play."
  fi
  echo "metrics.csv has a row a step, summary.json the totals."
fi
exit "$status"
