#!/usr/bin/env bash
# Tests of the tests of documents, with small documents. Each case_* function is one test; CTest runs `cases.sh NAME`.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# A small project with the commands and the scripts that test documents.
project=$work/project folder=$work/followed
mkdir -p "$project/tests" "$project/cmake"
cp -r "$here" "$project/tests/documents"
cp "$here/../../play" "$here/../../check" "$project/"
cp "$here/../../cmake/packages.txt" "$project/cmake/"

# A finished build whose program prints its arguments.
mkdir -p "$work/build/bin"
printf '#!/bin/sh\nfor a; do echo "[$a]"; done\n' >"$work/build/bin/fettle"
chmod +x "$work/build/bin/fettle"

# follow: tests the document on the standard input.
follow() {
    cat >"$work/page.md"
    status=0
    output=$("$project/tests/documents/follow.sh" "$@" "$work/page.md" "$work/build" "$folder" 2>&1) || status=$?
}
wrong() {
    printf 'wrong: %s\n--- status %s, output:\n%s\n' "$1" "$status" "$output"
    exit 1
}
expect_success() { [[ $status == 0 ]] || wrong "it should have worked"; }
expect_failure() {
    [[ $status == 1 ]] || wrong "it should have failed"
    [[ $output == *"$1"* ]] || wrong "the output should contain: $1"
}

case_commands_run_and_their_whole_output_is_compared() {
    follow <<'PAGE'
```sh
printf 'one\ntwo\n'
```

```text
one
two
```
PAGE
    expect_success
}

case_a_line_of_output_that_is_not_shown_is_a_failure() {
    follow <<'PAGE'
```sh
printf 'one\ntwo\n'
```

```text
one
```
PAGE
    expect_failure "+two"
    [[ $output == *"page.md:5: the output is another one"* ]] || wrong "the line of the block should be named"
}

case_errors_are_part_of_the_output() {
    follow <<'PAGE'
```sh
echo oh >&2
```

```text
oh
```
PAGE
    expect_success
}

case_times_of_day_may_differ_and_nothing_else() {
    follow <<'PAGE'
```sh
echo 'step 7, 23:59:01'
```

```text
step 7, 08:27:50
```
PAGE
    expect_success
    follow <<'PAGE'
```sh
echo 'step 8, 23:59:01'
```

```text
step 7, 08:27:50
```
PAGE
    expect_failure "+step 8"
}

case_commands_that_fail_are_a_failure() {
    follow <<'PAGE'
```sh
echo before
false
echo after
```
PAGE
    expect_failure "page.md:1: these commands fail"
    [[ $output == *before* && $output != *$'\nafter\n'*before* ]] || wrong "the output should be reported"
}

case_all_commands_are_typed_into_one_terminal() {
    follow <<'PAGE'
```sh
export NAME=value
mkdir ~/place && cd ~/place
```

Then:

```sh
echo "$NAME, ${PWD##*/}"
```

```text
value, place
```
PAGE
    expect_success
}

case_files_are_written_where_the_terminal_is() {
    follow <<'PAGE'
```sh
cd ~
```

```lua game/main.lua
print(1)
```

```sh
cat ~/game/main.lua
```

```text
print(1)
```
PAGE
    expect_success
}

case_the_terminal_begins_in_a_fresh_checkout() {
    follow <<'PAGE'
```sh
ls play check
ls -d build
```
PAGE
    expect_failure "cannot access 'build'"
    [[ $output == *$'check\nplay'* ]] || wrong "the commands should be there"
}

case_a_block_without_a_language_is_a_failure() {
    follow <<'PAGE'
```
./play
```
PAGE
    expect_failure "page.md:1: this block has no language"
}

case_an_indented_block_is_a_failure() {
    follow <<'PAGE'
# Title

    ./play
PAGE
    expect_failure "page.md:3: an indented block has no language"
}

case_a_language_that_no_test_can_run_is_a_failure() {
    follow <<'PAGE'
- in a list

  ```ruby
  print(1)
  ```
PAGE
    expect_failure "page.md:3: no test can run a block of ruby"
    follow <<<"<pre>x</pre>"
    expect_failure "no test can run a block of HTML"
}

case_a_block_that_does_not_end_is_a_failure() {
    follow <<'PAGE'
```sh
true
PAGE
    expect_failure "page.md:1: this block has no end"
}

case_a_block_of_code_without_a_file_is_a_failure() {
    follow <<'PAGE'
```cpp
int main() {}
```
PAGE
    expect_failure "page.md:1: a block of cpp needs the name of its file"
}

case_a_mark_runs_commands_that_the_reader_does_not_see() {
    follow <<'PAGE'
<!-- test: run cat
     there.lua -->

```lua there.lua
x = 1
```

```text
x = 1
```
PAGE
    expect_success
    follow <<'PAGE'
<!-- test: run false -->

```lua there.lua
x = 1
```
PAGE
    expect_failure "page.md:3: these commands fail"
}

case_an_unknown_mark_is_a_failure() {
    follow <<'PAGE'
<!-- test: sometimes -->
```sh
true
```
PAGE
    expect_failure "no such mark: test: sometimes"
}

case_what_is_typed_into_a_console_goes_to_the_game() {
    follow <<'PAGE'
<!-- test: console scripts/showcase at 10 20 -->
```console
› a = 1
  its answer
› b
› c
```
PAGE
    # The program of this project prints its arguments, which is not what the page shows.
    expect_failure "the output is another one"
    [[ $output == *'+[10:a = 1]'*'+[20:b]'*'+[21:c]'* ]] || wrong "the commands should have their steps"
    [[ $output == *'+[scripts/showcase]'*'+[--steps]'*'+[22]'* ]] || wrong "the game should be played to the end"
}

case_a_console_without_a_game_is_a_failure() {
    follow <<'PAGE'
```console
› a = 1
```
PAGE
    expect_failure "a console needs a mark"
}

case_output_without_commands_is_a_failure() {
    follow <<'PAGE'
```text
nothing printed this
```
PAGE
    expect_failure "this output belongs to no commands"
}

case_a_project_may_be_in_a_folder_with_a_space() {
    mv "$project" "$work/a project"
    mv "$work/build" "$work/a project/build"
    ln -s "$work/a project/build" "$work/build"
    project="$work/a project" folder="$work/a project/build/followed"
    follow <<'PAGE'
```sh
ls play && test -d $HOME && mkdir $HOME/place && cd $HOME/place
```

<!-- test: console scripts/showcase at 1 -->
```console
› a
```
PAGE
    expect_failure "+[--console]"
}

case_a_foreign_block_is_not_run() {
    follow <<'PAGE'
<!-- test: foreign -->
```gdscript
extends Node
```
PAGE
    expect_success
}

case_a_picture_without_a_mark_is_a_failure() {
    follow <<'PAGE'
![A ball](ball.png)
PAGE
    expect_failure "page.md:1: a picture needs a mark"
}

case_a_kept_picture_that_is_missing_is_a_failure() {
    printf 'a picture' >"$work/ball.png"
    follow <<'PAGE'
<!-- test: picture kept -->
![A ball](ball.png)
PAGE
    expect_success
    follow <<'PAGE'
<!-- test: picture kept -->
![A ball](box.png)
PAGE
    expect_failure "there is no"
}

case_a_picture_is_drawn_at_its_step_and_compared() {
    # This program draws its arguments; the comparison is one of files.
    printf '#!/bin/sh\nfor a; do file=$a; done\necho "$*" | sed "s/ --screenshot.*//" >"$file"\n' >"$work/build/bin/fettle"
    printf '#!/bin/sh\nshift\ncmp "$@"\n' >"$work/build/bin/fettle_pictures"
    printf '#!/bin/sh\nshift 3\nexec "$@"\n' >"$project/tests/documents/stand-ins/xvfb-run"
    chmod +x "$work/build/bin/"* "$project/tests/documents/stand-ins/xvfb-run"
    local page='<!-- test: picture game at 7 --seed 3 -->
![A game](game.png)

```lua game/main.lua
x = 1
```'
    follow --draw <<<"$page"
    expect_success
    [[ $(<"$work/game.png") == 'run game --headless --steps 7 --seed 3 '* ]] || wrong "drawn is: $(<"$work/game.png")"
    follow <<<"$page"
    expect_success
    printf 'another\n' >"$work/game.png"
    follow <<<"$page"
    expect_failure "look at both pictures"
}

case_a_picture_that_the_commands_made_is_compared() {
    local page='```sh
mkdir inside && cd inside && echo "<svg/>" >ball.svg
```

<!-- test: picture made ball.svg -->
![A ball](ball.svg)'
    follow --draw <<<"$page"
    expect_success
    [[ $(<"$work/ball.svg") == '<svg/>' ]] || wrong "the picture should be copied"
    follow <<<"$page"
    expect_success
    printf 'another\n' >"$work/ball.svg"
    follow <<<"$page"
    expect_failure "look at both pictures"
    follow <<<"${page/ball.svg -->/box.svg -->}"
    expect_failure "the commands before wrote no box.svg"
}

case_full_runs_only_the_blocks_that_are_marked_full() {
    local page='<!-- test: full -->
```sh
echo long; false
```

```sh
echo short
```'
    follow <<<"$page"
    expect_success
    follow --full <<<"$page"
    expect_failure "long"
}

# prepare: makes the checkout that pages link to.
prepare() {
    echo "as it was" >"$project/kept.txt"
    "$project/tests/documents/follow.sh" --prepare "$work/prepared"
    export FETTLE_PREPARED=$work/prepared
}

case_pages_may_replace_the_files_of_a_prepared_checkout_and_other_pages_do_not_see_it() {
    prepare
    follow <<'PAGE'
```sh
sed -i s/was/is/ kept.txt
cat kept.txt
```

```text
as it is
```

```lua tests/documents/cases.sh
print(1)
```
PAGE
    expect_success
    [[ $(<"$work/prepared/kept.txt") == "as it was" ]] || wrong "the next page should see the file as it was"
    cmp -s "$work/prepared/tests/documents/cases.sh" "$project/tests/documents/cases.sh" || wrong "a file of a page should be its own"
}

case_a_page_that_writes_into_a_file_of_a_prepared_checkout_is_a_failure() {
    prepare
    follow <<'PAGE'
```sh
echo more >>kept.txt
```
PAGE
    expect_failure "its commands write into files that all pages share: $work/prepared/kept.txt"
}

# reference: builds the reference of a header, which is on the standard input. The name decides whether it is one in C.
reference() {
    mkdir -p "$work/include/host"
    rm -f "$work"/include/host/* "$work"/include/*.h
    cat >"$work/include/$1"
    status=0
    output=$("$here/reference.sh" "$work/reference" "$work/include" 2>&1) || status=$?
    if [[ $status == 77 ]]; then exit 77; fi
}

case_a_public_member_without_a_comment_is_a_failure() {
    reference a.h <<'HEADER'
/// A thing.
struct Thing {
    int size() const;  ///< bytes
    int weight() const;
    void set_weight(int weight);
};
HEADER
    expect_failure "a.h:4: error: Member weight() const"
}

case_a_setter_in_the_reference_has_the_comment_of_its_getter() {
    reference a.h <<'HEADER'
/// A thing.
struct Thing {
    int weight() const;  ///< in kilograms
    void set_weight(int weight);
    /// How long it is,
    /// in meters.
    int length() const;
    void set_length(int length);
};
HEADER
    expect_success
    [[ $(grep -c 'in kilograms' "$work/reference/html/structThing.html") == 2 ]] || wrong "both should have the comment"
}

case_functions_in_c_without_an_empty_line_between_them_share_a_comment_in_the_reference() {
    reference host/a.h <<'HEADER'
/* Things. */

/** A thing. */
typedef struct thing {
    float x, y; /* where it is */
} thing;

/** Its weight. */
int thing_weight(const thing* of);
int thing_set_weight(thing* of, int weight);

int thing_length(const thing* of);
HEADER
    expect_failure "a.h:12: error: Member thing_length"
    [[ $output != *thing_set_weight* && $output != *"Member y"* ]] || wrong "the comments should be shared"
}

"$1"
