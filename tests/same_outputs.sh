#!/bin/bash
# What:  compares two builds of the programs: bytes of all files written, standard output, standard error and exit code,
#        for every verb with its important options, on real inputs, on the same inputs in other formats, and on broken
#        ones.
# usage: tests/same_outputs.sh OLD_BIN NEW_BIN [FOLDER...]
#        OLD_BIN and NEW_BIN are folders with rbpa and meshtopo. Without FOLDER, runs on files of at most 100 kB in
#        tests/data; with folders, on all of their files of at most 3 MB.
# Exit:  0 if nothing differs, 1 if something does, 2 if there is nothing to compare. The last line counts the runs.
set -u
. "$(dirname "$0")/refuse_options.sh"
here=$(cd "$(dirname "$0")" && pwd)
if [ $# -lt 2 ] || [ ! -x "$1/rbpa" ] || [ ! -x "$2/rbpa" ]; then
  echo "usage: tests/same_outputs.sh OLD_BIN NEW_BIN [FOLDER...]; found no rbpa in one of the first two" >&2
  exit 2
fi
old=$(cd "$1" && pwd) new=$(cd "$2" && pwd)
shift 2
limit=100k
[ $# -gt 0 ] && limit=3000k
folders=("${@:-$here/data}")

work=$(mktemp -d) && mkdir -p "$work"/{in,old,new} || exit 2
trap 'rm -rf "$work"' EXIT
ln -s ../in "$work/old/in" && ln -s ../in "$work/new/in"
runs=0 differ=0

# one FOLDER_OF_PROGRAMS SIDE PROGRAM ARGUMENT...: runs a program and puts all of its output into SIDE/out.
one() {
  local bin=$1 side=$2 program=$3
  shift 3
  cd "$work/$side" && rm -rf out && mkdir out || exit 2
  timeout 600 "$bin/$program" "$@" > out/standard_output 2> out/standard_error < "${input:-/dev/null}"
  echo $? > out/exit_code
}

# same PROGRAM ARGUMENT...
same() {
  (one "$old" old "$@") &
  (one "$new" new "$@")
  wait
  runs=$((runs + 1))
  diff -rq "$work/old/out" "$work/new/out" > "$work/difference" && return
  differ=$((differ + 1))
  echo "differs: $*${input:+ < $input}"
  sed "s,$work/,,g; s,^,  ," "$work/difference"
  diff "$work/old/out/standard_error" "$work/new/out/standard_error" | cut -c1-300 | sed 's,^,  ,'
}

plane() {
  same rbpa info "$1"
  same rbpa info "$1" --json
  same rbpa mesh "$1" --alpha plateau --threads 1 -o out/x.npy -o out/x.ply
  same rbpa shape "$1" --alpha plateau --threads 1 -o out/x.geojson -o out/x.csv
}
plane_all() {
  plane "$1"
  same rbpa discs "$1" --radius 1 --threads 2 -o out/x.csv -o out/x.wkt
  same rbpa mesh "$1" --alpha inf --threads 2 -o out/x.off -o out/x.obj -o out/x.vtu
  same rbpa mesh "$1" --alpha auto --complex full -o out/x.npy -o out/x.svg
  same rbpa mesh "$1" --alpha min --cover 0.9 --compact -o out/x.png -o out/x.off
  same rbpa mesh "$1" --alpha auto --method hrbpa -o out/x.npy
  same rbpa shape "$1" --alpha auto -o out/x.wkt -o out/x.svg --isolated out/i.geojson
  same rbpa alpha "$1" --json
  same rbpa alpha "$1" --csv
  same rbpa report "$1" -o out/x.html
  same rbpa stream "$1" --alpha 1 --memory 64M -o out/x.npy
  same rbpa info "$1" --crs EPSG:28992 --shift-longitude
}
space() {
  same rbpa surface "$1" --radius auto --threads 1 -o out/x.ply -o out/x.npy
}
space_all() {
  space "$1"
  same rbpa surface "$1" --radius auto --normals estimate -o out/x.off -o out/x.stl -o out/x.obj
  same rbpa surface "$1" --radius auto --normals file -o out/x.ply
}
mesh() {
  same meshtopo "$1"
  same meshtopo "$1" --json
}
polygons() {
  same rbpa fill "$1" --size inf -o out/x.off
  same rbpa fill "$1" --size 1 --quiet -o out/x.vtu
}

# Breaks a file in several ways: truncated, empty, with a faulty line at its end, compressed, with a name that is not
# UTF-8.
broken() {
  local file=$1 check=$2 name size
  name=$(basename "$file")
  size=$(stat -Lc %s "$file")
  for part in 0 1 40 $((size / 2)) $((size - 1)); do
    head -c "$part" "$file" > "$work/in/cut$part-$name"
    "$check" "in/cut$part-$name"
  done
  (cat "$file"; echo "9 9 x,") > "$work/in/more-$name"
  "$check" "in/more-$name"
  gzip -nc "$file" > "$work/in/packed-$name.gz"
  "$check" "in/packed-$name.gz"
  head -c $((size / 3)) "$work/in/packed-$name.gz" > "$work/in/cut-$name.gz"
  "$check" "in/cut-$name.gz"
  cp "$file" "$work/in/$(printf 'l\xe4tin')-$name"
  "$check" "in/$(printf 'l\xe4tin')-$name"
}
info_only() { same rbpa info "$1"; same rbpa stream "$1" --alpha 1 -o out/x.npy; }

# Common forms of tables, from lines of two or three numbers.
tables() {
  local points=$1 solid=$2 cells=$work/in
  awk 'BEGIN {print "id,lat,lon,class,z"} !/^#/ && NF > 1 {printf "%d,%s,%s,%d,%d\n", NR, $2, $1, NR % 3, NR % 7}' "$points" > "$cells/header.csv"
  awk '!/^#/ && NF > 1 {gsub(/\./, ","); print $1 ";" $2}' "$points" > "$cells/comma.csv"
  awk '!/^#/ && NF > 1 {print $1 "\t\"" $2 "\"\t" NR}' "$points" > "$cells/quotes.tsv"
  awk '!/^#/ && NF > 1 {print (NR % 50 == 0 ? "NA NA" : $1 " " $2)}' "$points" > "$cells/missing.txt"
  awk 'BEGIN {print "name;geom"} !/^#/ && NF > 1 {print NR ";POINT (" $1 " " $2 ")"}' "$points" > "$cells/geometries.csv"
  awk '!/^#/ && NF > 1 {print "SRID=28992;POINT Z (" $1 " " $2 " " NR ")"}' "$points" > "$cells/points.ewkt"
  awk 'BEGIN {printf "{\"type\":\"MultiPoint\",\"coordinates\":["} !/^#/ && NF > 1 {printf "%s[%s,%s]", s, $1, $2; s = ","} END {print "]}"}' \
    "$points" > "$cells/points.geojson"
  for name in header.csv comma.csv quotes.tsv missing.txt geometries.csv points.ewkt points.geojson; do
    plane "in/$name"
    same rbpa info "in/$name" --skip-invalid
    same rbpa stream "in/$name" --alpha 1 -o out/x.npy
    same rbpa info "in/$name" --columns 2,1
    same rbpa info "in/$name" --columns lat,lon
    same rbpa info "in/$name" --where 'class == 1 and not z > 5'
  done
  awk 'NF > 2 {print $1, $2, $3, NR % 256, 7, 255}' "$solid" > "$cells/colors.xyz"
  awk 'NF > 2 {print $1, $2, $3, 0.5, 0, -1}' "$solid" > "$cells/normals.xyz"
  awk 'BEGIN {print "x,y,z,red,green,blue,nx,ny,nz,class"} NF > 2 {printf "%s,%s,%s,%d,1,0,0,0,1,%d\n", $1, $2, $3, NR % 256, NR % 2}' "$solid" \
    > "$cells/all.csv"
  awk 'NF > 2 {print $1, $2, $3, NR % 9 == 0 ? "0 0 0" : "0 0 1"}' "$solid" > "$cells/undirected.xyz"
  for name in colors.xyz normals.xyz all.csv undirected.xyz; do
    space "in/$name"
    same rbpa surface "in/$name" --radius auto --skip-invalid -o out/x.ply
    same rbpa surface "in/$name" --radius auto --columns 3,1,2 -o out/x.npy
    same rbpa surface "in/$name" --radius auto --where 'class == 1' -o out/x.npy
    same rbpa info "in/$name"
  done
}

count=0
while IFS= read -r -d '' file; do
  name=$(basename "$file")
  cp "$file" "$work/in/$name" || exit 2
  count=$((count + 1))
  case $name in
    *.xy | *.f64xy | *.png | *.pgm | *.csv) plane_all "in/$name" ;;
    *.las) plane_all "in/$name"; space_all "in/$name"
      for where in 'classification == 2' 'z > 400 and not withheld' 'gps_time > 0' 'red > 100'; do
        same rbpa info "in/$name" --where "$where"
        same rbpa surface "in/$name" --radius auto --where "$where" --skip-invalid -o out/x.ply
        same rbpa stream "in/$name" --where "$where" --alpha 9 -o out/x.npy
      done ;;
    *.off | *.ply | *.obj | *.stl) mesh "in/$name"; space_all "in/$name"; same rbpa info "in/$name" ;;
    *.xyz | *.pcd) space_all "in/$name"; same rbpa info "in/$name" ;;
    *.wkt | *.geojson | *.poly) polygons "in/$name"; same rbpa info "in/$name" --vertices; same rbpa info "in/$name" ;;
    *) count=$((count - 1)) ;;
  esac
done < <(find -L "${folders[@]}" -maxdepth 1 -type f -size "-$limit" -print0 | sort -z)
if [ "$count" = 0 ]; then
  echo "no inputs in ${folders[*]}" >&2
  exit 2
fi

# The same points in other formats, which the old build writes, and broken files in each format.
points=$(find "$work/in" -name '*.xy' -size -40k | sort | head -n 1)
solid=$(find "$work/in" -name 'm3_cube*.off' -o -name 'm3_torus.off' | sort | tail -n 1)
if [ -n "$points" ] && [ -n "$solid" ]; then
  "$old/rbpa" mesh "$points" --alpha inf --quiet -o "$work/in/plane.off" -o "$work/in/plane.ply" -o "$work/in/plane.obj" 2> /dev/null
  "$old/rbpa" surface "$solid" --radius auto --quiet -o "$work/in/solid.ply" -o "$work/in/solid.stl" -o "$work/in/solid.obj" 2> /dev/null
  grep -E '^[-0-9.e]+ [-0-9.e]+ [-0-9.e]+$' "$solid" > "$work/in/solid.xyz"
  tables "$points" "$work/in/solid.xyz"
  python3 - "$points" "$work/in/solid.xyz" "$work/in" << 'PYTHON'
import struct, sys
points = [tuple(map(float, line.split()[:2])) for line in open(sys.argv[1]) if line[0] not in "#\n"]
solid = [tuple(map(float, line.split()[:3])) for line in open(sys.argv[2])]
def npy(name, rows, kind, code, columns_first=False):
    flat = [row[k] for k in range(len(rows[0])) for row in rows] if columns_first else [v for row in rows for v in row]
    if code in "hiq": flat = [int(v) for v in flat]
    head = "{'descr': '%s', 'fortran_order': %s, 'shape': (%d, %d), }" % (kind, columns_first, len(rows), len(rows[0]))
    head += " " * (63 - (10 + len(head)) % 64) + "\n"
    order = ">" if kind[0] == ">" else "<"
    open(f"{sys.argv[3]}/{name}.npy", "wb").write(
        b"\x93NUMPY\x01\x00" + struct.pack("<H", len(head)) + head.encode() + struct.pack(f"{order}{len(flat)}{code}", *flat))
npy("f8", points, "<f8", "d"); npy("f4", points, "<f4", "f"); npy("i4", points, ">i4", "i"); npy("columns", points, "<f8", "d", True)
npy("nan", points[:9] + [(1.0, float("nan"))], "<f8", "d"); npy("three", solid, "<f8", "d"); npy("three_columns", solid, ">f4", "f", True)
npy("six", [p + (0.0, 0.0, 1.0) for p in solid], "<f8", "d"); npy("undirected", [p + (0.0, 0.0, 0.0) for p in solid], "<f8", "d")
npy("four", [p + p for p in points], "<f8", "d")
open(f"{sys.argv[3]}/raw.f64xy", "wb").write(b"".join(struct.pack("<2d", *p) for p in points))
def ply(name, kind, order):
    head = f"ply\nformat {kind} 1.0\ncomment a list, a face\nelement vertex {len(solid)}\nproperty list uchar int tags\n" \
           "property uchar red\nproperty float x\nproperty double y\nproperty float z\nproperty uchar green\nproperty uchar blue\n" \
           "property short class\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    if kind == "ascii":
        body = "".join(f"2 {i} 7 {i % 256} {p[0]} {p[1]} {p[2]} 9 255 {i % 3}\n" for i, p in enumerate(solid)) + "3 0 1 2\n"
        open(f"{sys.argv[3]}/{name}.ply", "w").write(head + body)
        return
    body = b"".join(struct.pack(order + "B2iBfdfBBh", 2, i, 7, i % 256, *p, 9, 255, i % 3) for i, p in enumerate(solid))
    open(f"{sys.argv[3]}/{name}.ply", "wb").write(head.encode() + body + struct.pack(order + "B3i", 3, 0, 1, 2))
ply("lists", "ascii", ""); ply("little", "binary_little_endian", "<"); ply("big", "binary_big_endian", ">")
head = "VERSION .7\nFIELDS x y z normal_x normal_y normal_z rgb\nSIZE 4 4 4 4 4 4 4\nTYPE F F F F F F U\nCOUNT 1 1 1 1 1 1 1\n" \
       f"WIDTH {len(solid)}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {len(solid)}\nDATA "
open(f"{sys.argv[3]}/text.pcd", "w").write(head + "ascii\n" + "".join(f"{p[0]} {p[1]} {p[2]} 0 1 0 {i * 77}\n" for i, p in enumerate(solid)))
open(f"{sys.argv[3]}/bytes.pcd", "wb").write((head + "binary\n").encode() + b"".join(struct.pack("<6fI", *p, 0, 1, 0, i * 77) for i, p in enumerate(solid)))
text = "".join(f"{p[0]} {p[1]} {p[2]} 0 0 1 {i % 256} 3 4\n" for i, p in enumerate(solid))
open(f"{sys.argv[3]}/noff.off", "w").write(f"CNOFF\n{len(solid)} 0 0\n" + text)
open(f"{sys.argv[3]}/colors.obj", "w").write("".join(f"v {p[0]} {p[1]} {p[2]} 0.5 1 0\n" for p in solid))
PYTHON
  for file in "$work"/in/{f8,f4,i4,columns,nan,three,three_columns,six,undirected,four}.npy "$work"/in/raw.f64xy "$work"/in/{plane,noff}.off \
    "$work"/in/{plane,lists,little,big}.ply; do
    plane "in/$(basename "$file")"
    same rbpa stream "in/$(basename "$file")" --alpha 1 -o out/x.npy
  done
  for file in "$work"/in/{three,three_columns,six,undirected,f8,four}.npy "$work"/in/{solid,lists,little,big}.ply "$work"/in/{text,bytes}.pcd \
    "$work"/in/noff.off "$work"/in/{plane,solid,colors}.obj "$work"/in/solid.xyz; do
    space_all "in/$(basename "$file")"
  done
  for file in "$work"/in/plane.{off,ply,obj} "$work"/in/solid.{ply,stl,obj} "$work"/in/{lists,little,big}.ply; do mesh "in/$(basename "$file")"; done
  las=$(find "$work/in" -maxdepth 1 -name '*.las' | sort | head -n 1)
  for file in "$work"/in/{f8,columns}.npy "$work"/in/raw.f64xy "$work"/in/{header,comma,geometries}.csv ${las:+"$las"}; do broken "$file" info_only; done
  for file in "$work"/in/{plane,little,lists}.ply "$work"/in/{plane,noff}.off "$work"/in/points.{geojson,ewkt}; do broken "$file" plane; done
  for file in "$work"/in/{six,three_columns}.npy "$work"/in/{lists,big}.ply "$work"/in/{text,bytes}.pcd "$work"/in/noff.off "$work"/in/solid.obj \
    "$work"/in/{all.csv,colors.xyz} ${las:+"$las"}; do broken "$file" space; done
  for file in "$work"/in/solid.{ply,stl,obj} "$work"/in/plane.off; do broken "$file" mesh; done

  same rbpa stream "in/$(basename "$points")" --alpha 1 --tile-size 500 -o out/x.npy -o out/x.geojson

  # Wrong command lines, missing files, standard input.
  same rbpa info in/none.xy
  same rbpa info in
  same rbpa info in/f8.nothing
  same rbpa info in/f8.e57
  same rbpa info in/f8.npy --where 'class == 1'
  same rbpa info in/f8.npy --columns 1,2
  same rbpa info in/f8.npy --skip-invalid
  same rbpa info in/header.csv --where 'class =='
  same rbpa info in/header.csv --where 'nothing == 1'
  same rbpa info in/header.csv --columns 1,1
  same rbpa info in/header.csv --format las
  same rbpa info in/f8.npy --format none
  same rbpa info ''
  same rbpa surface --radius auto in/solid.png -o out/x.ply
  same rbpa surface --radius auto in/three.npy --columns 1,2,3 -o out/x.ply
  same rbpa surface --radius auto in/solid.xyz --format none -o out/x.ply
  same rbpa mesh in/f8.npy --alpha 1 -o out/x.nothing
  same meshtopo in/solid.xyz
  input=$work/in/f8.npy same rbpa mesh - --format npy --alpha 1 -o out/x.npy
  input=$work/in/header.csv same rbpa shape - --alpha auto -o out/x.wkt
  input=$work/in/solid.xyz same rbpa surface - --radius auto -o out/x.ply
  input=$work/in/packed-little.ply.gz same rbpa info - --format ply
fi

echo "$runs runs compared, $differ differ"
[ "$differ" = 0 ]
