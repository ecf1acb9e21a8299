#include <session/session.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <utility>

#include <fettle/app/error_screen.h>
#include <fettle/property/formula_problems.h>

#include <command_line/answer.h>
#include <ending/exit_status.h>
#include <files/archive.h>
#include <files/game_path.h>
#include <files/recorded_files.h>
#include <game/preferences.h>
#include <game/quota.h>
#include <session/console_layer.h>
#include <session/exports.h>
#include <session/game_window.h>
#include <terminal/terminal.h>

namespace fettle::program {

namespace {

/// The game. Throws FileError if it is not trusted and has native modules, before these run.
const std::filesystem::path& without_modules_in_sandbox(const RunOptions& options) {
    if (options.sandbox && (!options.modules.empty() || !manifest(options.game).empty()))
        throw FileError("--sandbox: a game in a sandbox cannot plug in native modules");
    return options.game;
}

}  // namespace

Session::Session(const RunOptions& options, app::Clipboard* clipboard,
                 std::function<void(const script::ScriptError&)> errors,
                 const app::Recording* replayed)
    : options_(options),
      receivers_{.errors = std::move(errors)},
      replayed_(replayed),
      assets_(files_, folder_of(options.game), assets()),
      modules_(without_modules_in_sandbox(options), options.modules),
      visuals_(&assets_),
      interface_(visuals_.media()) {
    make_files();
    read_settings();
    modules_.attach(tree_);
    visuals_.smooth_by_default(settings_.smooth);
    visuals_.attach(tree_);
    services_ = std::make_unique<app::Services>(tree_, &assets_);
    interface_.attach(tree_);
    services_->input.set_foreground(&interface_);
    services_->view.window = window_state(settings_);
    services_->view.screen = services_->view.window.size;
    receive_errors_of_tree();
    make_storage();
    const GameQuota quota = quota_of(options, settings_);
    if (quota.files > 0) files_.limit_writes(quota.files);
    runtime_ = std::make_unique<script::Runtime>(
        tree_, script::Options{.seed = seed(),
                               .memory_limit = quota.lua,
                               .limits = quota.scripts,
                               // No limit here; a window sets one, and so does --budget.
                               .call_seconds = 0,
                               .assets = assets(),
                               .saves = saves_.get(),
                               .tweaks = tweaks_.get(),
                               .store = store_.get(),
                               .files = &files_,
                               .media = &visuals_.media(),
                               .replay = options.replay.filename().string()});
    runtime_->on_error([this](const script::ScriptError& error) { fail(error); });
    runtime_->on_print([this](std::string_view text) { print(text); });
    runtime_->on_note([this](std::string_view text) { note("note: " + std::string(text)); });
    loop_ = std::make_unique<app::Loop>(tree_, *runtime_, *services_);
    loop_->timeline().on_dropped_branch([this](const std::string& line) { note(line); });
    loop_->on_error([this](const script::ScriptError& error) { fail(error); });
    loop_->before_step([this](std::uint64_t step) { run_at(step); });
    loop_->after_barrier([this] {
        tweaks_->barrier();
        report_repeated_errors();
#ifdef FETTLE_WITH_CONSOLE
        if (std::exchange(run_.stepped, false) && console_) console_->after_step();
#endif
    });
    add_modules();
    make_console(clipboard);
    if (options.test)
        test_ = std::make_unique<TestDriver>(*options.test, folder_of(options.game), files_,
                                             *services_, *runtime_);
}

void Session::receive_errors_of_tree() {
    tree_.on_handler_error([this](const property::HandlerError& error) {
        script::ScriptError report;
        report.message = error.message;
        report.context = "handler of " + error.path;
        if (!error.where.empty()) report.context += " (" + error.where + ")";
        fail(report);
    });
    property::on_formula_problem(tree_, [this](const property::FormulaProblem& problem) {
        script::ScriptError report;
        report.message = problem.message;
        report.context = "formula of " + problem.path;
        report_error(report);  // the run continues, and the property keeps its last valid value
    });
}

/// From now on messages go to stderr only, because the console ends before objects that report to
/// it.
Session::~Session() {
    run_.ending = true;
    report_repeated_errors();
}

/// A recording notes the files that the run reads; a replay gets the recorded content instead.
void Session::make_files() {
    files_.stay_below(folder_of(options_.game), assets());
    mount_archive(options_.game, files_);
    if (replayed_ != nullptr) use_recorded_content(*replayed_, options_.game, files_);
    if (isolated()) files_.stay_in_memory();
    if (!keeps_recording()) return;
    files_.record_reads();
    for (const std::filesystem::path& file : modules_.files()) files_.note_read(file);
}

void Session::read_settings() {
    if (options_.game.empty()) return;
    settings_ = property::read_game_settings(files_, options_.game, FETTLE_VERSION);
    // A headless run and a test are the same each time.
    if (settings_.random_seed && !options_.headless && !options_.test) {
        std::random_device device;
        settings_.seed = device();
    }
    if (settings_.icon.empty()) return;
    try {
        files_.note_read(
            assets_.find(settings_.icon_at + ": icon", settings_.icon, property::icon_endings));
    } catch (const property::Error& error) {
        throw FileError(error.what());
    }
}

std::uint64_t Session::seed() const {
    return options_.seed.value_or(settings_.seed.value_or(0));
}

std::string Session::icon() {
    const std::string& name = services_->view.window.icon;
    if (name.empty()) return {};
    return assets_.read("view.window.icon", name, property::icon_endings);
}

void Session::set_screen(const property::Vec2& size) {
    app::View& view = services_->view;
    view.screen = size;
    if (!view.window.fullscreen) view.window.size = size;
}

/// A test, or the picture of a game in the gallery, neither uses data of earlier runs nor leaves
/// data for later ones.
bool Session::isolated() const {
    return options_.isolated || options_.test.has_value();
}

void Session::make_storage() {
    // The original run has already written its tweaks and saves, so a replay writes none.
    const bool writes = replayed_ == nullptr && !isolated();
    property::TweakOptions of_tweaks{.files = &files_};
    const std::filesystem::path archive = archive_of(options_.game);
    if (isolated() || !archive.empty()) of_tweaks.earlier.emplace();
    if (!archive.empty())
        of_tweaks.not_kept_because = "this game is one file, " + archive.filename().string() +
                                     ", which no run changes; share(name) writes another file "
                                     "with this moment and its edits";
    if (replayed_ != nullptr) of_tweaks.earlier = replayed_->start().tweaks;
    tweaks_ = std::make_unique<property::Tweaks>(
        tree_, options_.game, [this](const std::string& warning) { note(warning); },
        std::move(of_tweaks));
    const std::filesystem::path folder = property::player_folder(options_.game, settings_.id);
    saves_ = std::make_unique<property::GameSaves>(
        tree_,
        property::Saves(folder.empty() ? folder : folder / "saves",
                        settings_.id.empty() ? property::game_title(options_.game) : settings_.id,
                        FETTLE_VERSION),
        property::GameSaves::Options{
            .writes = writes,
            .pictures = !options_.headless,
            .space = quota_of(options_, settings_).saves,
            .changed = [this](const std::string& slot) { visuals_.renew("save:" + slot); },
            .warn = [this](const std::string& text) { note(text); }});
    visuals_.saved_pictures([this](const std::string& slot) { return saves_->picture(slot); });
    store_ = new_store(KeptFile::store, folder);
    preferences_ = new_store(KeptFile::preferences, folder);
}

/// A replay has the values that the recorded run began with.
std::unique_ptr<property::Store> Session::new_store(KeptFile which,
                                                    const std::filesystem::path& folder) {
    property::Store::Options options{.writes = replayed_ == nullptr && !isolated(),
                                     .warn = [this](const std::string& text) { note(text); }};
    if (which == KeptFile::preferences) options.name = "the list of the player's preferences";
    if (isolated()) options.content.emplace();
    if (replayed_ != nullptr) options.content = recorded_text(which, *replayed_);
    return std::make_unique<property::Store>(folder.empty() ? folder : folder / name_of(which),
                                             std::move(options));
}

void Session::note(const std::string& text) {
    if (receivers_.output)
        receivers_.output(text);
    else
        print_error(text);
    if (listener_) listener_->print(text);
    if (run_.ending) return;
    if (console_)
        console_->note(text);
    else
        run_.early_notes.push_back(text);
}

void Session::add_modules() {
    for (module::Module* m : modules_.all())
        loop_->add({.name = std::string(m->name()),
                    .step = [m](double dt) { m->step(dt); },
                    .report =
                        [this, m] {
                            m->report(tree_);
                            run_.stepped = true;
                        },
                    .hash = [m] { return m->hash(); }});
    loop_->add({.name = std::string(visuals_.name()),
                .step = [this](double dt) { visuals_.step(dt); },
                .report = [this] { visuals_.report(tree_); },
                .hash = [this] { return visuals_.hash(); }});
    visuals_.on_problem(
        [this](const std::string& problem) { report_file_problem(problem, run_.renewed); });
    services_->on_effect_problem([this](const std::string& problem) {
        // The problem is found when the effect is drawn, so later than the change of the file.
        report_file_problem(problem, services_->view.effect);
    });
    loop_->add({.name = std::string(interface_.name()),
                .step = [this](double dt) { interface_.step(dt); },
                .report = [this] { interface_.report(tree_); },
                .hash = [this] { return interface_.hash(); }});
    interface_.on_problem([this](const std::string& problem) {
        script::ScriptError report;
        report.message = problem;
        report.context = "interface";
        report_error(report);  // the run continues, and the widget keeps its value
    });
    modules_.on_print([this](std::string_view text) { print(text); });
    modules_.on_error([this](const std::string& module, const std::string& message) {
        module_failed(module, message);
    });
    modules_.on_note([this](const std::string& text) { note("note: " + text); });
    loop_->between_frames([this] {
        modules_.renew();
        store_->tick();
        preferences_->tick();
        run_due_commands();
        listen();
        check_recording();
#ifdef FETTLE_WITH_CONSOLE
        if (console_) console_->between_frames();
#endif
    });
}

/// Whether `game.json` allows the console in this run. Commands given to the program are those of a
/// developer.
bool Session::has_console() const {
    switch (settings_.console) {
        case property::ConsoleUse::on:
            return true;
        case property::ConsoleUse::developer:
            return options_.developer || !options_.console.empty() || options_.listen;
        case property::ConsoleUse::off:
            break;
    }
    return false;
}

void Session::make_console(app::Clipboard* clipboard) {
    (void)clipboard;
    if (settings_.console == property::ConsoleUse::off && !options_.console.empty())
        throw FileError("--console: this game has no console, as its game.json says");
    if (settings_.console == property::ConsoleUse::off && options_.listen)
        throw FileError("--listen: this game has no console, as its game.json says");
    if (options_.sandbox && options_.listen)
        throw FileError("--listen: nothing may attach to a game in a sandbox");
#ifdef FETTLE_WITH_CONSOLE
    if (!has_console()) return;
    app::View& view = services_->view;
    console::Options options{
        .clipboard = clipboard,
        .to_world = [&view](
                        float x,
                        float y) { return view.to_world(property::Vec2(x, y) - view.corner()); },
        .to_pixels = [&view](property::Vec2 world) { return view.to_window(world); },
        .game_covered = [this] { return loop_->halted() && !viewing_past(); },
        .free_of_others =
            [this](const app::ClipRectangle& whole) {
                return loop_->free_area(whole, console_.get());
            },
        .tweaks = tweaks_.get(),
        .halted = [this] { return loop_->halted(); },
        .resume = [this] { loop_->resume(); },
        .review = [this](std::int64_t from, std::int64_t to,
                         const auto& visit) { loop_->timeline().review(from, to, visit); },
        .repeat_with =
            [this](std::int64_t from, const auto& change, const auto& visit) {
                loop_->timeline().repeat_with(from, change, visit);
            },
        .review_branch =
            [this](const std::string& branch, std::int64_t from, const auto& visit) {
                loop_->timeline().review_branch(branch, from, visit);
            },
        .scripts_draw = [this] { return runtime_->draws(); },
        .share = [this](const std::string& name) { return share(name); },
        .record = [this](bool on) { return record(on); },
        .records = keeps_recording()
                       ? [this] { return recorder_ && !recorder_->writes_to().empty(); }
                       : std::function<bool()>(),
        .restart = [this] { restart(); },
        .script =
            [this](const std::string& file) {
                constexpr std::string_view lua[] = {".lua"};
                return assets_.read("script", file, lua);
            },
        .frames = &services_->clock.frames,
        .on_result = [this](const std::string& line) { print_result(line); },
        .write_file =
            [this](const std::string& kind, const std::string& content) {
                return write_export(new_export(kind), content);
            },
        .write_picture =
            [this](float width, float height, const auto& draw) {
                return draw_export(new_export("png"), width, height, draw);
            },
        .replay = replayed_ != nullptr};
    if (!options_.headless) options.history_file = console::default_history_file();
    load_players_console(options);
    console_ = std::make_unique<ConsoleLayer>(tree_, *runtime_, std::move(options));
    for (const std::string& text : run_.early_notes) console_->note(text);
    if (options_.listen) console_->listen(true);
#endif
}

void Session::restart() {
    if (replayed_ != nullptr) return;  // a recording ends there
    const auto refuse = [](const std::string& why) {
        throw property::Error(property::ErrorKind::rejected, "restart: " + why);
    };
    if (tree_.cause().writer != property::Writer::console)
        refuse(
            "only a command of the console begins the game again; a script goes back with "
            "restore(beginning), if main.lua has beginning = snapshot(), or with go_to_scene");
    if (options_.headless) refuse("only a game in a window begins again");
    run_.restart = true;
}

void Session::travel(int steps) {
    const app::Clock& clock = services_->clock;
    if (!clock.timeline.go_to || clock.newest <= clock.oldest) return;
    clock.timeline.go_to(std::clamp(clock.step + steps, clock.oldest, clock.newest));
}

void Session::select(const std::vector<property::Handle>& instances) {
    if (console_)
        console_->select(instances);
    else
        runtime_->set_selected(instances.back());
}

script::Evaluation Session::evaluate(std::string_view command, std::string_view who) {
    if (console_) return console_->answer_terminal(command, who);
    return runtime_->evaluate(command);
}

std::optional<std::vector<std::string>> Session::waited(std::string_view who) {
    return console_ ? console_->waited(who) : std::vector<std::string>();
}

void Session::stop_waiting(std::string_view who) {
    if (console_) console_->stop_waiting(who);
}

void Session::add_layer(app::Layer& layer) {
    loop_->add(layer);
}

void Session::start() {
    make_recorder();
#ifdef FETTLE_WITH_CONSOLE
    // A replay gets the console's input from the recording.
    if (console_ && options_.replay.empty()) loop_->add(*console_);
#endif
    follow_preferences(*preferences_, interface_);
    run_.loaded = runtime_->load(options_.game);
    if (!run_.loaded && !runtime_->interrupted()) run_.failed = true;
    if (run_.loaded) open_moment();
    if (follows_files()) {
        watch_.changed(watched_files());
        // Files that the run writes itself, such as kept tweaks, need no reload: the game has these
        // values.
        files_.on_write([this](const std::filesystem::path& file) {
            watch_.mark_seen(std::filesystem::absolute(file).lexically_normal());
        });
    }
    tweaks_->game_loaded();
    if (const std::size_t open = tweaks_->open_earlier(); open > 0 && replayed_ == nullptr)
        note(std::to_string(open) +
             (open == 1 ? " edit of an earlier run is" : " edits of earlier runs are") +
             " not made again yet: tweaks() lists " + (open == 1 ? "it" : "them") +
             ", reapply_tweaks(\"**\") makes " + (open == 1 ? "it" : "them") + " again");
    for (const std::string& chunk : options_.evals) {
        if (loop_->stopped() || run_.failed) return;
        if (!runtime_->run(chunk, "eval") && !runtime_->interrupted()) run_.failed = true;
    }
    if (test_ && !loop_->stopped() && !run_.failed && !test_->start()) run_.failed = true;
    if (recorder_) recorder_->begin(tree_, *loop_);
}

void Session::print(std::string_view text) {
    print_outside_console(text);
    if (console_) console_->print(text);
}

/// Prints the output of a command of --console.
void Session::print_from_option(const std::string& text) {
    print_outside_console(text);
    if (console_) console_->output(text);
}

/// Prints what a command has led to after its answer, such as the result of a search, where its
/// answer was printed: that is not known, so in each terminal.
void Session::print_result(const std::string& line) {
    const std::string indented = line_after_answer(line);
    if (options_.headless) print_line(indented);
    if (listener_) listener_->print(indented);
}

void Session::print_outside_console(std::string_view text) {
    if (receivers_.output)
        receivers_.output(text);
    else
        print_line(text);
    if (!options_.headless) std::fflush(stdout);
    if (listener_) listener_->print(text);
}

void Session::run_at(std::uint64_t step) {
    if (!loop_->stopped()) run_.chunks_until = step;
    for (const auto& [when, chunk] : options_.at)
        if (when == step && !loop_->stopped())
            (void)runtime_->run(chunk, "at " + std::to_string(step));
    if (test_ && !loop_->stopped()) test_->turn();
}

/// Runs the commands of --console that are due, between frames as if they were typed. So a
/// recording contains them like typed commands.
void Session::run_due_commands() {
    const std::uint64_t next = loop_->steps_made() + 1;
    if (next == run_.typed) return;
    // A frame in a window may have made several steps.
    const std::uint64_t before = std::exchange(run_.typed, next);
    for (const auto& [when, command] : options_.console) {
        if (when <= before || when > next || loop_->stopped()) continue;
        print_from_option("› " + command);
        const script::Evaluation said =
            console_ ? console_->evaluate(command) : runtime_->evaluate(command);
        for (const std::string& line : lines_of(said)) print_from_option(line);
    }
    // The output must not be lost if the run crashes.
    if (!options_.console.empty()) std::fflush(stdout);
}

int Session::exit_status() const {
    if (run_.failed) return script_error;
    return runtime_->quit_status().value_or(success);
}

}  // namespace fettle::program
