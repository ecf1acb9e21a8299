# To be sourced: reads the blocks of a Markdown document for its tests.
# shellcheck shell=bash

# read_blocks FILE fills these arrays, an element for each block of the document, in its order:
#   block_line   the line of its fence, or its first line if it is only indented
#   block_kind   the language after the fence; "" if there is none, "indented", "html" (<pre>), "open" (no end) or
#                "picture": a line that begins with an image
#   block_file   the text after the language: the name of a file; of a picture, its link
#   block_mark   the text of the comment <!-- test: ... --> before it
#   block_text   its lines, without the indentation of its fence
read_blocks() {
    block_line=() block_kind=() block_file=() block_mark=() block_text=()
    local field=0 value
    while IFS= read -r -d '' value; do
        case $((field++ % 5)) in
            0) block_line+=("$value") ;;
            1) block_kind+=("$value") ;;
            2) block_file+=("$value") ;;
            3) block_mark+=("$value") ;;
            4) block_text+=("$value") ;;
        esac
    done < <(awk '
        function put(line, kind, file, text) {
            printf "%s%c%s%c%s%c%s%c%s%c", line, 0, kind, 0, file, 0, mark, 0, text, 0
            mark = ""
        }
        function end_of_indented() { if (indented) put(indented, "indented", "", text); indented = 0 }
        # Inside a block: it ends at a fence of the same kind that is at least as long.
        fence != "" {
            rest = $0
            sub(/^ +/, "", rest)
            if (index(rest, fence) == 1 && rest ~ /^(`+|~+) *$/) {
                put(start, kind, file, text)
                fence = ""
            } else {
                match($0, /^ */)
                text = text substr($0, 1 + (RLENGTH < indent ? RLENGTH : indent)) "\n"
            }
            next
        }
        # Inside a comment of several lines.
        comment { if (/-->/) { comment = 0; finish_mark() } else heard = heard " " $0; next }
        function finish_mark() {
            sub(/-->.*/, "")
            heard = heard " " $0
            if (heard ~ /^ *test: /) { sub(/^ *test: */, "", heard); gsub(/ +/, " ", heard); sub(/ $/, "", heard); mark = heard }
            heard = ""
        }
        match($0, /^ *(```+|~~~+)/) {
            end_of_indented()
            start = FNR
            match($0, /^ */)
            indent = RLENGTH
            rest = substr($0, indent + 1)
            match(rest, /^(`+|~+)/)
            fence = substr(rest, 1, RLENGTH)
            rest = substr(rest, RLENGTH + 1)
            sub(/^ +/, "", rest)
            kind = file = rest
            sub(/ .*/, "", kind)
            sub(/^[^ ]* */, "", file)
            text = ""
            next
        }
        match($0, /^ *<!--/) {
            end_of_indented()
            heard = ""
            sub(/^ *<!-- */, "")
            if (/-->/) finish_mark(); else { heard = $0; comment = 1 }
            next
        }
        match($0, /^!\[[^]]*\]\([^)]*\)/) {
            end_of_indented()
            file = substr($0, RSTART, RLENGTH)
            sub(/^!\[[^]]*\]\(/, "", file)
            sub(/\)$/, "", file)
            put(FNR, "picture", file, "")
            next
        }
        /^ *<pre/ { end_of_indented(); put(FNR, "html", "", $0 "\n"); next }
        /^$/ { if (indented) text = text "\n"; blank = 1; next }
        # Four spaces after an empty line begin a block, except in a list, whose items have the same indentation.
        /^(    |\t)/ && (indented || (blank && !list)) {
            if (!indented) { indented = FNR; text = "" }
            sub(/^(    |\t)/, "")
            text = text $0 "\n"
            next
        }
        # Text between a mark and a block: the mark does not belong to the block.
        { end_of_indented(); mark = ""; blank = /^#/; list = /^ *([-*+]|[0-9]+[.)]) / || (list && /^ /) }
        END {
            end_of_indented()
            if (fence != "") put(start, "open", "", text)
        }' "$1")
}
