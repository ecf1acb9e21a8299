#!/usr/bin/env bash
# The behavior of `play`, `check` and cmake/bootstrap.sh. Each case_* function is one test; CTest runs
# `commands.sh NAME`. A case works on a copy of the commands in a small project whose path has a space,
# with a dpkg-query, apt-get, apt-cache, id, sudo and xvfb-run that do nothing but write down how they were called.
set -euo pipefail

repository=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
export TMPDIR=$work  # the logs of an apt that fails stay there
project="$work/a project"
fakes=$work/fakes
calls=$work/calls
installed=$work/installed
known=$work/known
asked=$work/asked  # a line for each time that apt was asked what it knows

pretend() {
    cat >"$fakes/$1"
    chmod +x "$fakes/$1"
}

set_up() {
    mkdir -p "$project/cmake" "$project/tests" "$fakes"
    touch "$calls" "$installed" "$known"
    cp "$repository/play" "$repository/check" "$repository/CMakePresets.json" "$project/"
    cp "$repository/cmake/bootstrap.sh" "$project/cmake/"
    cat >"$project/cmake/packages.txt" <<'LIST'
# a comment
core   compiler
build  new-name | old-name  # renamed
play   driver
display screen
bench  rival
test   driver
test   nicety ?
LIST
    printf '%s\n' compiler new-name driver screen rival | tee "$known" >"$installed"

    pretend dpkg-query <<<"#!/bin/sh
sed 's/^/installed /' '$installed'"
    pretend apt-cache <<<"#!/bin/sh
echo >>'$asked'
status=100
for name; do
    if grep -qx -- \"\$name\" '$known'; then echo \"Package: \$name\"; status=0; fi
done
exit \$status"
    pretend apt-get <<<"#!/bin/sh
echo \"apt-get \$*\" >>'$calls'
case \" \$* \" in
*' update '*) [ ! -e '$work/newer' ] || cp '$work/newer' '$known' ;;
*' install '*)
    [ ! -e '$work/stale' ] || { rm '$work/stale'; echo 'E: 404 not found' >&2; exit 100; }
    while [ \$1 != install ]; do shift; done
    shift
    printf '%s\n' \"\$@\" >>'$installed'
    echo dlstatus:1:50:half; echo pmstatus:compiler:100:done ;;
esac"
    pretend id <<<"#!/bin/sh
cat '$work/user'"
    echo 0 >"$work/user"
    pretend sudo <<<"#!/bin/sh
[ -e '$work/sudo' ] || exit 1
echo sudo >>'$calls'
shift
exec \"\$@\""
    pretend xvfb-run <<<"#!/bin/sh
echo \"xvfb-run \$*\" >>'$calls'"

    # A program that repeats its arguments, and three tests with the three possible ends.
    mkdir "$project/scripts"
    cat >"$project/CMakeLists.txt" <<'PROJECT'
cmake_minimum_required(VERSION 3.25)
project(Small LANGUAGES NONE)
enable_testing()
file(WRITE "${CMAKE_BINARY_DIR}/bin/fettle" "#!/bin/sh\nfor a; do echo \"[$a]\"; done\npwd\nexit 7\n")
file(CHMOD "${CMAKE_BINARY_DIR}/bin/fettle" PERMISSIONS OWNER_READ OWNER_EXECUTE)
set(FETTLE_PARTS everything CACHE STRING "The parts to build")
add_custom_target(fettle)
add_custom_target(fettle-bench)
add_custom_target(fettle_physics_module COMMAND "${CMAKE_COMMAND}" -E touch "${CMAKE_BINARY_DIR}/core of ${FETTLE_PARTS}")
add_custom_target(fettle_installed COMMAND "${CMAKE_COMMAND}" -E touch "${CMAKE_BINARY_DIR}/to be installed")
add_test(NAME "it works" COMMAND true)
if(EXISTS "${CMAKE_SOURCE_DIR}/tests/harbor")
  add_custom_target(everything_else ALL COMMAND "${CMAKE_COMMAND}" -E touch "${CMAKE_BINARY_DIR}/all was built")
  add_custom_target(test_harbor COMMAND "${CMAKE_COMMAND}" -E touch "${CMAKE_BINARY_DIR}/the harbor was built")
  add_test(NAME "ships sail" COMMAND true)
  set_tests_properties("ships sail" PROPERTIES LABELS harbor)
endif()
if(EXISTS "${CMAKE_SOURCE_DIR}/broken")
  add_test(NAME "a < b & \"c\"" COMMAND false)
  add_test(NAME "gone" COMMAND no-such-program)
  add_test(NAME "not here" COMMAND sh -c "exit 4")
  set_tests_properties("not here" PROPERTIES SKIP_RETURN_CODE 4)
endif()
PROJECT
    mkdir "$project/vector" "$project/framework" "$project/physics" "$project/bindings" "$project/console" "$project/fettle" \
        "$project/bench" "$project/examples"
    export PATH="$fakes:$PATH" DISPLAY=:77
    unset WAYLAND_DISPLAY
}

# run COMMAND...: its output in $output, its exit status in $status.
run() {
    status=0
    output=$("$@" 2>&1 </dev/null) || status=$?
}

wrong() {
    printf 'wrong: %s\n--- status %s, output:\n%s\n--- calls of tools:\n' "$1" "$status" "$output"
    cat "$calls"
    exit 1
}
expect_status() { [[ $status == "$1" ]] || wrong "the status should be $1"; }
expect_output() { [[ $output == *"$1"* ]] || wrong "the output should contain: $1"; }
expect_call() { grep -qF -- "$1" "$calls" || wrong "this call should have been made: $1"; }
expect_no_call() { ! grep -qF -- "$1" "$calls" || wrong "this call should not have been made: $1"; }
last_line() { tail -n 1 <<<"$output"; }

case_apt_is_not_called_when_no_package_is_missing() {
    run "$project/check"
    expect_status 0
    [[ ! -s $calls ]] || wrong "no tool should have been called"
}

case_the_name_of_a_folder_of_tests_builds_and_runs_only_these() {
    mkdir "$project/tests/harbor"
    touch "$project/tests/harbor/CMakeLists.txt" "$project/tests/harbor/harbor_test.cpp"
    run "$project/check" harbor
    expect_status 0
    [[ $(last_line) == "1 passed, 0 failed" ]] || wrong "only the test of the harbor should have run"
    [[ -e "$project/build/release/the harbor was built" ]] || wrong "the harbor should have been built"
    [[ ! -e "$project/build/release/all was built" ]] || wrong "nothing else should have been built"
}

case_progress_tells_how_long_the_rest_will_take() {
    source "$repository/cmake/bootstrap.sh"
    # A clock of its own: three of four parts are done after sixty seconds.
    slow_line() { began=$((SECONDS - 60)) current=work; progress work "$1" 4; }
    output=$(with_progress slow_line <<<3)
    expect_output "work, 3 of 4, about 20 s left"
    output=$(with_progress slow_line <<<4)
    expect_output "work, 4 of 4"
    [[ $output != *left* ]] || wrong "nothing is left"
    slow_line() { began=$((SECONDS - 600)) current=work; progress work "$1" 4; }
    output=$(with_progress slow_line <<<1)
    expect_output "about 30 min left"
}

case_root_installs_only_what_is_missing() {
    printf '%s\n' compiler new-name driver rival >"$installed"
    run "$project/check"
    expect_status 0
    expect_output "installing 1 missing packages: screen"
    expect_call "--no-install-recommends install screen"
    expect_no_call compiler
    expect_no_call update
    expect_no_call sudo
}

case_apt_is_asked_once_what_it_knows_of_all_packages() {
    true >"$installed"
    run "$project/check"
    expect_status 0
    # Of the core, and of the others when it is there; each time also whether the lists of packages have been read.
    (($(wc -l <"$asked") <= 5)) || wrong "apt was asked $(wc -l <"$asked") times"
}

case_sudo_without_a_password_installs() {
    echo 1000 >"$work/user"
    touch "$work/sudo"
    echo compiler >"$installed"
    run "$project/play" --build
    expect_status 0
    expect_call sudo
    expect_call "install driver new-name rival"
}

case_without_root_the_command_to_run_is_printed() {
    echo 1000 >"$work/user"
    echo compiler >"$installed"
    run "$project/play"
    expect_status 2
    expect_output "sudo apt-get update && sudo apt-get install -y --no-install-recommends driver new-name"
    [[ ! -s $calls ]] || wrong "no tool should have been called"
}

case_any_installed_alternative_of_a_package_is_enough() {
    printf '%s\n' compiler old-name driver screen rival >"$installed"
    run "$project/check"
    expect_status 0
    [[ ! -s $calls ]] || wrong "no tool should have been called"
}

case_the_first_alternative_that_apt_knows_is_installed() {
    printf '%s\n' compiler old-name driver screen rival >"$known"
    printf '%s\n' compiler driver screen rival >"$installed"
    run "$project/check"
    expect_status 0
    expect_call "install old-name"
}

case_an_optional_package_is_installed_only_where_apt_knows_it() {
    run "$project/check"
    [[ ! -s $calls ]] || wrong "no tool should have been called"
    echo nicety >>"$known"
    run "$project/check"
    expect_status 0
    expect_call "install nicety"
}

case_missing_package_lists_are_read_first() {
    cp "$known" "$work/newer"
    : >"$known"
    : >"$installed"
    run "$project/play" --build
    expect_status 0
    [[ $(head -n 1 "$calls") == *" update" ]] || wrong "the lists should have been read first"
    expect_call "install compiler"
    expect_call "install driver new-name rival"
}

case_outdated_package_lists_are_read_again() {
    : >"$installed"
    touch "$work/stale"
    run "$project/play" --build
    expect_status 0
    expect_call " update"
    (($(grep -c " install compiler" "$calls") == 2)) || wrong "it should have been tried twice"
}

case_the_output_of_apt_is_shown_when_it_fails() {
    : >"$installed"
    pretend apt-get <<<"#!/bin/sh
echo 'E: no space left' >&2
exit 100"
    run "$project/check"
    expect_status 2
    expect_output "E: no space left"
}

case_the_scripts_of_packages_may_print() {
    : >"$installed"
    # Like apt, it closes the file descriptor of its status before a script of a package runs.
    pretend apt-get <<<"#!/bin/sh
status=\$(echo \"\$*\" | sed 's/.*Status-Fd=\([0-9]*\).*/\1/')
eval \"echo pmstatus:compiler:50:half >&\$status\"
eval \"exec \$status>&-\"
printf 'Regenerating... ' || { echo 'E: the script failed' >&2; exit 100; }
echo install >>'$calls'"
    run "$project/check"
    expect_status 0
    expect_call "install"
}

case_on_systems_without_apt_the_packages_are_listed() {
    # Only these tools: no dpkg-query, no apt-get.
    mkdir "$work/tools"
    local tool
    for tool in bash sh cat sed sort awk grep dirname basename readlink mkdir nproc env cmake ninja true; do
        ln -s "$(command -v "$tool")" "$work/tools/$tool"
    done
    PATH=$work/tools run "$project/play" --build
    expect_status 0
    expect_output "compiler"
    expect_output "new-name|old-name"
}

case_play_passes_its_arguments_to_fettle_run() {
    mkdir "$work/elsewhere"
    cd "$work/elsewhere"
    run "$project/play" "my game" --seed 3
    expect_status 7
    expect_output $'[run]\n[my game]\n[--seed]\n[3]\n'"$work/elsewhere"
}

case_packages_that_only_running_needs_are_installed_before_the_game_runs() {
    printf '%s\n' compiler new-name >"$installed"
    run "$project/play" game
    expect_status 7
    expect_output "[run]"
    expect_call "install driver"
    expect_no_call compiler
}

case_the_core_is_built_while_other_packages_are_installed() {
    echo compiler >"$installed"
    # Waits for the core as long as a slow machine may need for it.
    pretend apt-get <<<"#!/bin/sh
for i in \$(seq 600); do [ ! -e '$project/build/release/core of physics_module' ] || break; sleep 0.1; done
ls '$project/build/release' >>'$calls'
echo dlstatus:1:50:half"
    run "$project/play" game
    expect_status 7
    expect_output "installing 2 missing packages: driver new-name"
    expect_call "core of physics_module"
    grep -qx "FETTLE_PARTS:STRING=everything" "$project/build/release/CMakeCache.txt" || wrong "all parts should be configured in the end"
    rm "$project/build/release/core of physics_module"
    pretend apt-get <<<"#!/bin/sh"
    run "$project/play" game
    [[ ! -e "$project/build/release/core of physics_module" ]] || wrong "the core should be built before other parts only once"
}

case_a_build_of_the_core_that_stopped_is_completed() {
    mkdir -p "$project/build/release"
    run cmake --preset release -S "$project" -B "$project/build/release" -DFETTLE_PARTS:STRING=physics_module
    expect_status 0
    run "$project/play" game
    expect_status 7
    grep -qx "FETTLE_PARTS:STRING=everything" "$project/build/release/CMakeCache.txt" || wrong "all parts should be configured"
}

case_a_game_does_not_run_without_the_packages_that_running_needs() {
    printf '%s\n' compiler new-name >"$installed"
    pretend apt-get <<<"#!/bin/sh
echo 'E: no space left' >&2
exit 100"
    run "$project/play" game
    expect_status 2
    expect_output "E: no space left"
    [[ $output != *"[run]"* ]] || wrong "the game should not run"
}

case_play_build_builds_what_is_installed() {
    run "$project/play" --build
    expect_status 0
    [[ -e "$project/build/release/to be installed" ]] || wrong "the target fettle_installed should have been built"
    expect_output "what cmake --install installs"
}

case_an_installation_of_what_is_not_built_names_it_and_copies_nothing() {
    cmake -S "$repository" -B "$work/build" -G Ninja -DFETTLE_PARTS=property -DFETTLE_BUILD_TESTS=OFF \
        -DFETTLE_BUILD_BENCH=OFF >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
    local component
    for component in "" "--component development" "--component runtime"; do
        # shellcheck disable=SC2086
        run cmake --install "$work/build" --prefix "$work/prefix" $component
        expect_status 1
        expect_output "Nothing was installed"
        expect_output "framework/property/libfettle_property.a"
        expect_output "./play --build"
        expect_output "cmake --build $work/build --target fettle_installed"
        [[ ! -e $work/prefix ]] || wrong "nothing should have been copied"
    done
}

case_play_alone_opens_the_showcase() {
    run "$project/play"
    expect_output $'[run]\n['"$project/scripts/showcase]"
}

case_play_without_a_display_writes_a_picture() {
    unset DISPLAY
    run "$project/play"
    expect_status 0
    expect_output "no display"
    expect_output "$project/build/showcase.png"
    expect_call "run $project/scripts/showcase --screenshot $project/build/showcase.png --steps 240"
}

case_play_runs_a_headless_game_without_a_display() {
    unset DISPLAY
    run "$project/play" game.lua --headless --steps 3
    expect_status 7
    expect_no_call xvfb-run
    expect_output $'[game.lua]\n[--headless]\n[--steps]\n[3]'
}

case_a_build_folder_that_was_moved_is_made_again() {
    run "$project/check"
    expect_status 0
    mv "$project" "$work/moved"
    project=$work/moved
    run "$project/check"
    expect_status 0
    expect_output "configuring it anew"
}

case_check_builds_the_benchmark_only_for_long_runs_or_where_it_was_built_before() {
    local cache=$project/build/release/CMakeCache.txt
    run "$project/check"
    grep -q "^FETTLE_BUILD_BENCH:.*=OFF$" "$cache" || wrong "it is not needed"
    run "$project/check" harbor
    grep -q "^FETTLE_BUILD_BENCH:.*=ON$" "$cache" || wrong "a test of it may match"
    run "$project/check"
    grep -q "^FETTLE_BUILD_BENCH:.*=ON$" "$cache" || wrong "it was built before"
    rm -r "$project/build"
    run "$project/check" --sanitize
    grep -q "^FETTLE_BUILD_BENCH:.*=ON$" "$cache" || wrong "a long run tests it"
}

case_the_summary_names_what_failed() {
    touch "$project/broken"
    run "$project/check"
    expect_status 1
    expect_output 'FAILED   a < b & "c"'
    expect_output "FAILED   gone"
    expect_output "skipped  not here"
    [[ $(last_line) =~ ^[12]\ passed,\ 2\ failed,\ [12]\ skipped$ ]] || wrong "the last line is the count"
}

case_the_summary_names_the_bounds_that_a_benchmark_exceeds() {
    cat >>"$project/CMakeLists.txt" <<'PROJECT'
file(WRITE "${CMAKE_BINARY_DIR}/bin/fettle-bench" "#!/bin/sh
[ \"$2\" = --help ] || echo \"the table $1\"
[ $1 != tree ] || printf 'exceeded: tree \"get ball.mass\" 2.00 of the barest (bound 1.75)\\n'
[ $1 != stability ] || [ \"$2\" = --help ] || exit 2
")
file(CHMOD "${CMAKE_BINARY_DIR}/bin/fettle-bench" PERMISSIONS OWNER_READ OWNER_EXECUTE)
PROJECT
    run "$project/check" --full
    expect_output "the table tree"
    expect_output "fettle-bench stability did not finish"
    expect_output "the table past"
    local end=${output##*the table past}
    [[ $end == *'exceeded tree "get ball.mass" 2.00 of the barest (bound 1.75)'* ]] ||
        wrong "the summary should name the bound"
    [[ $end != *"FAILED   tree"* ]] || wrong "a bound is not a test"
}

case_the_full_check_tries_the_other_hosts() {
    mkdir -p "$project/tests/hosts"
    cat >"$project/tests/hosts/run.sh" <<'HOSTS'
#!/usr/bin/env bash
[[ $1 != --list ]] || { echo raft; exit; }
echo "the $1 leaks"
exit 1
HOSTS
    chmod +x "$project/tests/hosts/run.sh"
    run "$project/check" --full
    expect_status 1
    expect_output "the raft leaks"
    expect_output "FAILED   hosts: raft"
}

case_clang_tidy_reads_what_the_compiler_gets_and_each_source() {
    cat >>"$project/CMakeLists.txt" <<'PROJECT'
file(WRITE "${CMAKE_BINARY_DIR}/compile_commands.json" "[\n{\n  \"file\": \"/several sources.cxx\"\n}\n]\n")
PROJECT
    touch "$project/framework/sail.cpp"
    pretend clang-tidy-14 <<<"#!/bin/sh
[ \"\$1\" != --version ] || { echo 'LLVM version 14.0.6'; exit; }
echo \"clang-tidy \$*\" >>'$calls'
case \$* in *framework/sail.cpp) echo 'sail.cpp:1:1: error: it is torn'; exit 1 ;; esac"
    run "$project/check" --full
    expect_output "sail.cpp:1:1: error: it is torn"
    expect_output "FAILED   clang-tidy"
    grep -q -- 'build/tidy .*/several sources.cxx$' "$calls" || wrong "it should read what the compiler gets"
    grep -q -- 'build/alone .*clang-analyzer.* framework/sail.cpp$' "$calls" || wrong "it should read each source"
}

case_a_broken_build_fails_the_check() {
    echo 'message(FATAL_ERROR "no such library")' >>"$project/CMakeLists.txt"
    run "$project/check"
    expect_status 1
    expect_output "no such library"
    expect_output "FAILED   build"
    [[ $(last_line) =~ passed,\ 1\ failed ]] || wrong "the last line is the count"
    run "$project/play" --build
    expect_status 1
}

case_a_part_of_a_name_selects_tests() {
    touch "$project/broken"
    run "$project/check" works
    expect_status 0
    [[ $(last_line) == "1 passed, 0 failed" ]] || wrong "one test matches"
    run "$project/check" nonsense
    expect_status 1
    expect_output "no test matches nonsense"
}

case_an_unknown_option_is_bad_usage() {
    run "$project/check" --fast
    expect_status 2
    expect_output "unknown option --fast"
}

set_up
"$1"
