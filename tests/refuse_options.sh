# Sourced by scripts first of all, with their arguments: --help prints the lines of the script from "# usage:" on, and what else begins
# with - is refused before anything is done. MOST_ARGUMENTS, where it is set, is how many the script takes.
if [ "${1-}" = --help ] || [ "${1-}" = -h ]; then
  sed -n '/^# usage:/,/^[^#]/s/^# \{0,1\}//p' "$0"
  exit 0
fi
for argument in "$@"; do
  case $argument in
    -*)
      echo "$(basename "$0"): found '$argument', expected no options (see --help)" >&2
      exit 2
      ;;
  esac
done
if [ $# -gt "${MOST_ARGUMENTS-$#}" ]; then
  echo "$(basename "$0"): found $# arguments, expected at most $MOST_ARGUMENTS (see --help)" >&2
  exit 2
fi
unset argument
