#!/usr/bin/env bash
# Builds the site in build/site: the pages of docs/, the references of C++ (Doxygen) and Python (docstrings), and a page
# that computes in the browser.
# Needs Sphinx with MyST and the theme of Read the Docs, Doxygen, and builds of the presets `release` and `javascript`.
# usage: docs/site/build.sh
set -euo pipefail
MOST_ARGUMENTS=0
. "$(dirname "$0")/../../tests/refuse_options.sh"
cd "$(dirname "$0")/../.."
root=$PWD pages=$PWD/build/site_pages
for needed in build/release/python/rbpa/__init__.py build/javascript/javascript/index.js; do
  [ -e "$needed" ] || { echo "$needed is not there: build the presets release and javascript first" >&2; exit 1; }
done
rm -rf build/site "$pages"
mkdir -p "$pages/extra/rbpa"

# Pages, in their folders, so that links still work. README is the first page. Files that are not on the site keep their
# names, without a link.
mkdir -p "$pages/docs" "$pages/extra/docs"
cp -r docs/README.md docs/{tutorials,how_to,reference,explanation,contributing,figures} "$pages/docs"
cp -r docs/figures "$pages/extra/docs"  # for images in HTML
cp README.md "$pages/index.md"
cp CONTRIBUTING.md CHANGELOG.md "$pages"
sed -i -E 's#\[([^]]*)\]\((\.\./)*(apps|tests|libmeshops|librbpa|packaging|debian|docs/drawings|drawings|CITATION|LICENSE)[^)]*\)#\1#g' "$pages"/*.md "$pages"/docs/{,*/}*.md
sed -i 's#](\.\./\.\./README\.md#](../../index.md#g' "$pages"/docs/*/*.md
sed -i 's#](\.\./README\.md#](../index.md#g' "$pages/docs/README.md"
sed -i 's#](README\.md#](index.md#g' "$pages"/*.md

# References.
{
  echo '# Python reference'
  PYTHONPATH=build/release/python /usr/bin/python3 - <<'PYTHON'
import inspect, rbpa
for name in sorted(rbpa.__all__):
    item = getattr(rbpa, name)
    if name.startswith("__"):
        continue
    kind = "autoclass" if inspect.isclass(item) else "autofunction"
    members = "\n   :members:" if kind == "autoclass" and not issubclass(item, Exception) else ""
    print(f"\n## {name}\n\n```{{eval-rst}}\n.. {kind}:: rbpa.{name}{members}\n```")
PYTHON
} > "$pages/python_reference.md"
{
  cat docs/site/Doxyfile
  echo "OUTPUT_DIRECTORY = $root/build/site_pages/extra"
  echo "INPUT = $(echo libmeshops/meshops libmeshops/meshops/*/ librbpa/rbpa/{,base,plane,fill,space/{solid,surface,repair,simplify,persistence,balls}})"
} | doxygen -

# The page that computes in the browser.
cp docs/site/try.html "$pages/extra/"
cp build/javascript/javascript/index.js "$pages/extra/rbpa/"
cp tests/data/mol_2xhe_xy.xy "$pages/extra/molecule.xy"

# Navigation by folders; the pages of each in the order in which a reader needs them.
navigation() {  # CAPTION PAGE...
  printf '\n```{toctree}\n:hidden:\n:caption: %s\n\n' "$1"
  printf '%s\n' "${@:2}" '```'
}
{
  navigation Tutorials docs/tutorials/{first_shape,lidar_footprint,scan_to_print,cavities}
  navigation "How to" docs/how_to/{choose_alpha,polygons,more_points_than_memory,cpp_project,javascript,repair_a_mesh,coming_from,write_a_front,add_a_file_format}
  navigation Reference docs/reference/{command_line,file_formats,cpp_headers,python,operators,guarantees_and_limits,performance} python_reference
  navigation Explanation docs/explanation/{architecture,exact_decisions,plane,space,surfaces,filtration_and_persistence,paper}
  navigation Contributing CONTRIBUTING docs/contributing/{testing,style} CHANGELOG docs/README
} >> "$pages/index.md"
sed -i 's/^## What it does/<a href="try.html">Try it in the browser<\/a> · [Python reference](python_reference.md) · <a href="cpp\/index.html">C++ reference<\/a>\n\n&/' "$pages/index.md"
cp docs/site/conf.py "$pages"
PYTHONPATH=build/release/python /usr/bin/python3 -m sphinx -q -W --keep-going -j auto -b html "$pages" build/site
echo "build/site/index.html"
