#!/usr/bin/env bash
# The site, in build/site: the pages of docs/, the references of C++ (Doxygen) and Python (docstrings), and a page that computes in the browser.
# Needs Sphinx with MyST and the theme of Read the Docs, Doxygen, and what the presets `release` and `javascript` have built.
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

# Pages. README is the first one; what is not on the site keeps its name, without a link.
cp -r docs/*.md docs/figures "$pages"
cp -r docs/figures "$pages/extra"  # for images in HTML
cp README.md "$pages/index.md"
cp CONTRIBUTING.md "$pages/contributing.md"
cp CHANGELOG.md "$pages/changelog.md"
sed -i -E 's#\]\(docs/([^)]*)\)#](\1)#g; s#"docs/figures/#"figures/#g' "$pages"/{index,contributing,changelog}.md
sed -i -E 's#\]\((\.\./)?CONTRIBUTING\.md#](contributing.md#g; s#\]\((\.\./)?CHANGELOG\.md#](changelog.md#g; s#\]\((\.\./)?README\.md#](index.md#g
  s#\[([^]]*)\]\((\.\./|apps/|tests/|libmeshops/|librbpa/|packaging/|drawings|CITATION|LICENSE)[^)]*\)#\1#g' "$pages"/*.md

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
  echo "INPUT = $(echo libmeshops/meshops libmeshops/meshops/{core,front,graph,handle,history,patch,stellar,topology} librbpa/rbpa librbpa/rbpa/base)"
} | doxygen -

# The page that computes.
cp docs/site/try.html "$pages/extra/"
cp build/javascript/javascript/index.js "$pages/extra/rbpa/"
cp tests/data/mol_2xhe_xy.xy "$pages/extra/molecule.xy"

cat >> "$pages/index.md" <<'MARKDOWN'

```{toctree}
:hidden:
:glob:
:caption: Pages

*
```
MARKDOWN
sed -i '0,/^```sh/s//<a href="try.html">Try it in the browser<\/a> · [Python reference](python_reference.md) · <a href="cpp\/index.html">C++ reference<\/a>\n\n```sh/' "$pages/index.md"
cp docs/site/conf.py "$pages"
PYTHONPATH=build/release/python /usr/bin/python3 -m sphinx -q -W --keep-going -j auto -b html "$pages" build/site
echo "build/site/index.html"
