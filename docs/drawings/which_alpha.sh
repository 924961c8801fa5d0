#!/bin/bash
# Draws the pictures of docs/how_to/choose_alpha.md: shapes of real sets at the alphas that the page discusses.
# usage: bash docs/drawings/which_alpha.sh PROGRAM FOLDER...
#   PROGRAM  rbpa
#   FOLDER   folders of point sets: tests/data, and one with the two sets that are not there
set -euo pipefail
. "$(dirname "$0")/../../tests/refuse_options.sh"
if [ $# -lt 2 ]; then
  bash "$0" --help >&2
  exit 2
fi
program=$1
shift
out=$(dirname "$0")/../figures/which_alpha
mkdir -p "$out"

draw() {  # SET WIDTH NAME ALPHA...
  local set=$1 width=$2 name=$3 folder
  shift 3
  for folder in "${folders[@]}"; do
    [ -f "$folder/$set.xy" ] || continue
    "$program" shape "$folder/$set.xy" --alpha "$@" --width "$width" -o "$out/$name.png"
    return
  done
  echo "$set: found in none of ${folders[*]}; its picture stays as it is" >&2
}

folders=("$@")
draw geo_usgs_quakes_week 560 quakes_auto auto
draw geo_usgs_quakes_week 560 quakes plateau
draw lidar_ahn_delft_west 240 delft_auto auto
draw lidar_ahn_delft_west 240 delft plateau
draw geo_us_zipcodes 560 zipcodes_auto auto
draw geo_us_zipcodes 560 zipcodes plateau
for each in lidar_autzen_trim:autzen lidar_certainty3d:cliff shape_skimage_horse_fill:horse \
  shape_manifold_bigsponge:sponge mol_2xhe_xy:molecule geo_lightning_a:lightning shape_smap_dstorm:dstorm \
  shape_hdbscan_clusterable:clusterable shape_poly2tri_nazca_monkey:monkey; do
  draw "${each%:*}" 280 "${each#*:}" plateau
done
draw shape_hdbscan_clusterable 280 clusterable_by_hand 0.015
draw shape_poly2tri_nazca_monkey 280 monkey_second plateau:2
