#include <session/game_window.h>

#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/last_value.h>
#include <fettle/property/utf8.h>

#include <session/session.h>

namespace fettle::program {

app::WindowState window_state(const property::GameSettings& settings) {
    app::WindowState state;
    if (const std::string title = settings.title(); !title.empty()) state.title = title;
    const property::WindowSettings& window = settings.window;
    state.icon = settings.icon;
    state.size = window.size.value_or(state.size);
    state.fullscreen = window.fullscreen.value_or(state.fullscreen);
    state.resizable = window.resizable.value_or(state.resizable);
    state.vsync = window.vsync.value_or(state.vsync);
    return state;
}

namespace {

app::WindowState at_start(const property::GameSettings& settings,
                          const property::PlayerSettings& player) {
    app::WindowState state = window_state(settings);
    state.fullscreen = player.fullscreen.value_or(state.fullscreen);
    return state;
}

void write(property::Tree& tree, property::Handle to, const char* name,
           const property::Value& value) {
    static std::function<std::string()> where = [] { return std::string("the player"); };
    const property::Tree::CauseScope cause(tree, property::Writer::module, &where);
    tree.set(to, name, value);
}

}  // namespace

GameWindow::GameWindow(const std::filesystem::path& game, const property::GameSettings& settings)
    : folder_(property::player_folder(game, settings.id)),
      player_(property::read_player_settings(folder_)),
      window_(app::open_window(at_start(settings, player_))),
      fullscreen_(at_start(settings, player_).fullscreen) {}

void GameWindow::before_start(Session& session) {
    session.set_screen(window_->size());
    show_icon(session);
    clipboard_.clear();
}

void GameWindow::show_icon(Session& session) {
    const std::string& name = session.services().view.window.icon;
    if (name == icon_) return;
    icon_ = name;
    if (name.empty()) return;
    try {
        if (!window_->set_icon(session.icon()))
            session.note("view.window.icon: \"" + name + "\" is not an image that can be shown");
    } catch (const property::Error& error) {
        session.note(error.what());
    }
}

/// Sets them through the tree, so that a recording contains them as writes, and a replay does not
/// depend on the settings of the player.
void GameWindow::started(Session& session) {
    const app::View& view = session.services().view;
    if (player_.fullscreen) {
        set(session, "fullscreen", *player_.fullscreen);
        // The window has the size of the screen, and gets its own when it is no longer fullscreen.
        if (*player_.fullscreen && view.window.size == view.screen)
            set(session, "size", window_state(session.settings()).size);
    }
    fullscreen_ = view.window.fullscreen;
}

void GameWindow::set(Session& session, const char* name, const property::Value& value) {
    property::Tree& tree = session.tree();
    const property::Handle window = tree.child(tree.child(tree.root(), "view"), "window");
    if (tree.alive(window)) write(tree, window, name, value);
}

/// Through the tree, for the same reason: a replay pastes what was pasted.
void GameWindow::read_clipboard(Session& session) {
    constexpr std::size_t most = 1 << 20;
    clipboard_ = window_->clipboard().read();
    clipboard_.resize(property::code_point_boundary(clipboard_, most));
    property::Tree& tree = session.tree();
    write(tree, tree.child(tree.root(), "input"), "clipboard", clipboard_);
}

void GameWindow::write_clipboard(Session& session) {
    const property::Tree& tree = session.tree();
    const property::Value text = last_value(tree, tree.child(tree.root(), "input"), "clipboard");
    if (text.text() == clipboard_) return;
    clipboard_ = text.text();
    window_->clipboard().write(clipboard_);
}

bool GameWindow::handle(const app::InputEvent& event, Session& session) {
    const bool pressed = event.kind == app::EventKind::key_pressed;
    if (pressed && event.control && event.name == "v" && !session.console_is_open())
        read_clipboard(session);
    const bool wanted =
        pressed && !event.repeated && (event.name == "f11" || (event.name == "enter" && event.alt));
    if (wanted) set(session, "fullscreen", !session.services().view.window.fullscreen);
    return wanted;
}

void GameWindow::follow(Session& session) {
    const app::WindowState& state = session.services().view.window;
    window_->follow(state);
    show_icon(session);
    write_clipboard(session);
    if (state.fullscreen == fullscreen_) return;
    fullscreen_ = state.fullscreen;
    player_.fullscreen = fullscreen_;
    try {
        property::write_player_settings(folder_, player_);
    } catch (const std::exception& error) {
        session.note("the setting of the window is not kept: " + property::exception_text(error));
    }
}

}  // namespace fettle::program
