# Sourced by scripts first of all, with their arguments: --help prints the script's lines from "# usage:" on, and any
# other argument that begins with - is refused before anything is done. MOST_ARGUMENTS, if set, is the greatest number
# of arguments.
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
