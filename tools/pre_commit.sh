#!/usr/bin/env bash
# Git's hook before a commit, which `./dev hooks` installs: the format of the files that are committed, includes, words. It takes three
# seconds; `git commit --no-verify` goes without.
set -euo pipefail
cd "$(git rev-parse --show-toplevel)"

committed() { git diff --cached --name-only --diff-filter=d -- "$@"; }
# formatted STYLE PATTERN...: those files have the format of the style.
formatted() {
    local style=$1 files
    shift
    mapfile -t files < <(committed "$@")
    ((${#files[@]} == 0)) || clang-format --style="$style" --dry-run --Werror "${files[@]}"
}

if command -v clang-format >/dev/null; then
    formatted file '*.h' '*.cpp' '*.inl'
    formatted file:shaders/.clang-format '*.glsl' '*.comp' '*.vert' '*.frag'
else
    echo "pre-commit: clang-format is not installed; ./dev format installs it." >&2
fi
python3 -B tests/structure/check_includes.py . >/dev/null || python3 -B tests/structure/check_includes.py .
python3 -B tests/structure/check_words.py . --code >/dev/null || python3 -B tests/structure/check_words.py . --code
