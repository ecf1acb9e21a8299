#include "game.h"

#include <fettle/property/formula_problems.h>
#include <fettle/property/snapshot_remarks.h>

namespace fettle::host {

namespace {

/// The clipboard of the caller.
class HostClipboard : public app::Clipboard {
  public:
    explicit HostClipboard(Game& game) : game_(game) {}
    std::string read() override {
        const auto callback = game_.callbacks.read_clipboard;
        if (callback.function == nullptr) return kept_;
        std::string text;
        game_.call_out([&] {
            if (const char* const given = callback.function(callback.user)) text = given;
        });
        return text;
    }
    void write(std::string_view text) override {
        kept_ = text;
        const auto callback = game_.callbacks.write_clipboard;
        if (callback.function == nullptr) return;
        game_.call_out([&] { callback.function(callback.user, std::string(text).c_str()); });
    }

  private:
    Game& game_;
    std::string kept_;
};

property::Tree& attached(physics_module::PhysicsModule& physics, property::Tree& tree) {
    physics.attach(tree);
    return tree;
}

script::Options options_of(const fettle_hosted_def& def, const PlayerFiles& files) {
    script::Options options;
    options.saves = files.saves.get();
    options.tweaks = files.tweaks.get();
    options.store = files.store.get();
    options.seed = def.seed;
    options.memory_limit = def.lua_memory;
    options.call_seconds = def.call_seconds;
    if (def.assets != nullptr) options.assets = def.assets;
    return options;
}

property::Vec2 unmapped(const property::Transform& map, property::Vec2 pixel) {
    const double area = map.area();
    const double dx = pixel.x - map.origin.x, dy = pixel.y - map.origin.y;
    return property::Vec2((dx * map.y.y - dy * map.y.x) / area,
                          (dy * map.x.x - dx * map.x.y) / area);
}

}  // namespace

Game::Game(const fettle_hosted_def& def)
    : services(attached(physics, tree)),
      files(tree, def, [this](const std::string& text) { note(text); }),
      lua(tree, options_of(def, files)),
      loop(tree, lua, services) {
    loop.add({.name = "physics",
              .step = [this](double dt) { physics.step(dt); },
              .report =
                  [this] {
                      physics.report(tree);
                      stepped_ = true;
                  },
              .hash = [this] { return physics.hash(); }});
    connect_callbacks();
    if (flag(def.console)) make_console(def);
    open = true;
    for (const std::string& text : early_notes)
        if (console) console->note(text);
}

/// The files are closed after the objects that may still write messages to them.
Game::~Game() {
    open = false;
}

void Game::connect_callbacks() {
    lua.on_error([this](const script::ScriptError& error) { report(error); });
    loop.on_error([this](const script::ScriptError& error) { report(error); });
    tree.on_handler_error([this](const property::HandlerError& error) {
        script::ScriptError found;
        found.message = error.message;
        found.context = "handler of " + error.path;
        report(found);
    });
    property::on_formula_problem(tree, [this](const property::FormulaProblem& problem_found) {
        script::ScriptError found;
        found.message = problem_found.message;
        found.context = "formula of " + problem_found.path;
        report(found);
    });
    lua.on_print([this](std::string_view text) {
        if (console) console->print(text);
        const auto callback = callbacks.print;
        if (callback.function == nullptr) return;
        try {
            call_out([&] { callback.function(callback.user, std::string(text).c_str()); });
        } catch (...) {
            // An exception here would leave the call in the middle of the script.
            if (!first_problem_)
                first_problem_ = "the function that gets the output of print failed";
        }
    });
    lua.on_note([this](std::string_view text) {
        if (console) console->note(text);
    });
    loop.after_barrier([this] {
        files.after_barrier();
        if (std::exchange(stepped_, false) && console) console->after_step();
    });
    loop.between_frames([this] {
        files.between_frames();
        if (console) console->between_frames();
    });
}

void Game::make_console(const fettle_hosted_def& def) {
    clipboard = std::make_unique<HostClipboard>(*this);
    console::Options options{
        .clipboard = clipboard.get(),
        .to_world = [this](float x, float y) -> property::Vec2 {
            if (!view) return services.view.to_world({x, y});
            return unmapped(*view, property::Vec2(x, y));
        },
        .to_pixels = [this](property::Vec2 world) -> property::Vec2 {
            return view ? (*view)(world) : services.view.to_screen(world);
        },
        .tweaks = files.tweaks.get(),
        .review = [this](std::int64_t from, std::int64_t to,
                         const auto& look) { loop.timeline().review(from, to, look); },
        .repeat_with = [this](
                           std::int64_t from, const auto& change,
                           const auto& look) { loop.timeline().repeat_with(from, change, look); },
        .review_branch =
            [this](const std::string& branch, std::int64_t from, const auto& look) {
                loop.timeline().review_branch(branch, from, look);
            },
        .frames = &services.clock.frames};
    if (def.history_file != nullptr) options.history_file = def.history_file;
    console = std::make_unique<console::Console>(tree, lua, std::move(options));
}

Game::CallbackScope::CallbackScope(Game& game) : game_(game) {
    if (game_.callbacks_ >= 8)
        throw Failure{FETTLE_LOCKED, "more than eight calls of functions of the host are nested"};
    ++game_.callbacks_;
}

void Game::require_outside(const char* what) const {
    if (callbacks_ > 0)
        throw Failure{FETTLE_LOCKED, std::string("the game is calling a function: it cannot ") +
                                         what + " before that has returned"};
}

void Game::report(const script::ScriptError& error) {
    if (!first_problem_) first_problem_ = error.message;
    if (console) console->report(error);
    report_to_caller(error);
}

void Game::note(const std::string& text) {
    if (open && console) console->note(text);
    if (!open || callbacks.problem.function == nullptr) {
        constexpr std::size_t most = 100;
        if (early_notes.size() < most) early_notes.push_back(text);
        return;
    }
    note_to_caller(text);
}

void Game::note_remarks(const std::string& state) {
    // A function for problems may restore another state.
    const std::vector<std::string> remarks = property::restore_remarks(tree);
    for (const std::string& remark : remarks) note(state + ": " + remark);
}

void Game::note_to_caller(const std::string& text) {
    script::ScriptError found;
    found.message = text;
    found.context = "files";
    report_to_caller(found);
}

void Game::deliver_early_notes() {
    for (const std::string& text : std::exchange(early_notes, {})) note_to_caller(text);
}

void Game::report_to_caller(const script::ScriptError& error) {
    const auto callback = callbacks.problem;
    if (callback.function == nullptr) return;
    const fettle_hosted_problem found{.message = error.message.c_str(),
                                      .file = error.file.c_str(),
                                      .source_line = error.source_line.c_str(),
                                      .traceback = error.traceback.c_str(),
                                      .context = error.context.c_str(),
                                      .line = error.line};
    try {
        call_out([&] { callback.function(callback.user, &found); });
    } catch (...) {
        // The call that runs the script reports the error in any case.
        return;
    }
}

console::Console& Game::needed_console() {
    if (!console) throw Failure{FETTLE_INVALID, "this game was created without a console"};
    return *console;
}

}  // namespace fettle::host
