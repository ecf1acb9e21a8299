// Routing of input events.

#include <algorithm>
#include <utility>

#include <fettle/property/edits.h>
#include <fettle/property/exception_text.h>

#include <in_game/pick.h>
#include <inspector/multi_selection.h>
#include <look/imgui_compat.h>
#include <panel/state.h>

namespace fettle::console {

using app::EventKind;
using app::InputEvent;

bool Console::State::handle(const InputEvent& event) {
    follow_settings();
    if (event.kind != EventKind::text) type_letter();
    if (event.kind == EventKind::key_pressed || event.kind == EventKind::key_released) {
        // The event of a modifier may have the state before it.
        const bool down = event.kind == EventKind::key_pressed;
        input.shift_held = event.name.ends_with("_shift") ? down : event.shift;
        input.control_held = event.name.ends_with("_control") ? down : event.control;
    }
    switch (event.kind) {
        case EventKind::key_pressed:
            return press_key(event);
        case EventKind::key_released:
            return release_key(event);
        case EventKind::text:
            return type_text(event);
        case EventKind::mouse_pressed:
        case EventKind::mouse_released:
        case EventKind::mouse_moved:
        case EventKind::wheel:
            return mouse(event);
        case EventKind::focus:
            if (!event.focused) lose_focus();
            return false;
        default:
            return false;
    }
}

void Console::State::lose_focus() {
    ui.release_all();
    input.keys.clear();
    input.buttons.clear();
    input.box.reset();
    input.shift_held = input.control_held = false;
    input.swallow_text = input.may_be_dead = false;
}

// --- Keyboard

// Shift and the grave key give a tilde, which Lua needs.
bool Console::State::press_key(const InputEvent& event) {
    bool bare = !event.shift && !event.control && !event.alt;
    if (bare && event.name == settings.text("key")) {
        input.swallow_text = true;
        if (event.repeated) return true;
        input.may_be_dead = event.name == "grave";
        input.keys.press(event.name, HeldKeys::Owner::console);
        open(!is_open());
        return true;
    }
    input.swallow_text = false;
    if (run_key(event)) return true;
    if (!status.was_open) {
        input.keys.press(event.name, HeldKeys::Owner::game);
        return false;
    }
    if (input.keys.held_by_game(event.name))
        return true;  // auto-repeat of a key that the game holds
    input.keys.press(event.name, HeldKeys::Owner::console);
    note_letter(event);
    if (event.name == "f" && event.control && !event.alt) {
        if (!settings.flag("inspector")) settings.set("inspector", property::Value(true));
        status.inspector_over_log = true;
        inspector.begin_search();
    } else if (focused_widget_key(event)) {
        return true;
    } else if (widgets_have_keyboard()) {
        if (event.name != "tab" || screen.popup_open || !inspector.tab(event.shift)) feed(event);
    } else {
        ui.feed_modifiers(event);
        if (!selection_key(event)) prompt_key(event);
    }
    return true;
}

/// A clicked field, or one to which the focus moves, gets the keyboard one frame later.
void Console::State::wait_for_focus() {
    for (int i = 0; i < 3 && inspector.about_to_type(); ++i) frame(0);
}

bool Console::State::focused_widget_key(const InputEvent& event) {
    wait_for_focus();
    Fields& fields = inspector.editor().fields();
    const bool modifier = event.name.ends_with("_shift") || event.name.ends_with("_control");
    if (!fields.widget_has_focus() || modifier || screen.popup_open) return false;
    if (event.name == "tab") return inspector.tab(event.shift);
    const bool presses = event.name == "space" || event.name == "enter";
    input.swallow_text = event.name == "space";
    presses ? fields.press_widget() : fields.unfocus_widget();
    return presses || event.name == "escape";
}

bool Console::State::run_key(const InputEvent& event) {
    const bool function_key = event.name.size() > 1 && event.name[0] == 'f' &&
                              event.name[1] >= '0' && event.name[1] <= '9';
    if (status.was_open && !function_key) return false;
    const std::string command = observing.command_of_key(event.name);
    if (command.empty() || input.keys.held_by_game(event.name)) return false;
    input.keys.press(event.name, HeldKeys::Owner::console);
    status.used = true;
    if (!event.repeated) run(command);
    input.swallow_text = !status.was_open;  // the character that the key types
    return true;
}

bool Console::State::release_key(const InputEvent& event) {
    if (event.name == settings.text("key")) input.swallow_text = false;
    HeldKeys::Owner owner = input.keys.release(event.name);
    if (status.was_open) feed(event);
    if (owner == HeldKeys::Owner::none) return status.was_open;
    return owner == HeldKeys::Owner::console;
}

bool Console::State::type_text(const InputEvent& event) {
    if (input.swallow_text) {
        input.may_be_dead = false;
        return true;
    }
    if (!status.was_open) return false;
    // A letter with the accent of a dead key stands for the letter.
    if (const char32_t letter = std::exchange(input.letter, 0);
        letter != 0 && event.character > 0x7f) {
        InputEvent plain = event;
        plain.character = letter;
        return type_text(plain);
    }
    if (event.character == U'`' && settings.text("key") == "grave") return true;
    // Control and a letter give a control character, which widgets and the prompt do not use.
    if (event.character < 0x20 || event.character == 0x7f) return true;
    if (widgets_have_keyboard() && !leaves_menu(event.character))
        feed(event);
    else
        prompt.type(event.character);
    return true;
}

void Console::State::note_letter(const InputEvent& event) {
    if (!std::exchange(input.may_be_dead, false)) return;
    const bool letter = event.name.size() == 1 && event.name[0] >= 'a' && event.name[0] <= 'z';
    if (!letter || event.control || event.alt) return;
    input.letter = static_cast<char32_t>(event.shift ? event.name[0] - 'a' + 'A' : event.name[0]);
}

void Console::State::type_letter() {
    if (input.letter == 0) return;
    InputEvent event;
    event.kind = EventKind::text;
    event.character = std::exchange(input.letter, 0);
    type_text(event);
}

/// A letter that no field of an open menu takes closes the menu: it is the beginning of a command.
bool Console::State::leaves_menu(char32_t character) {
    if (character == U' ') return false;  // chooses an entry
    // A field of a menu that has just been opened gets the keyboard some frames later.
    for (int i = 0; i < 3 && !ImGui::IsAnyItemActive(); ++i) frame(0);
    ui.activate();
    if (ImGui::IsAnyItemActive()) return false;
    ui.close_menus();
    screen.popup_open = false;
    return true;
}

bool Console::State::widgets_have_keyboard() {
    // A press that no frame has processed yet may give a field the keyboard.
    if (input.fed_button) frame(0);
    wait_for_focus();
    inspector.give_up_search();
    ui.activate();
    return screen.width > 0 && (ImGui::IsAnyItemActive() || screen.popup_open);
}

void Console::State::prompt_key(const InputEvent& event) {
    Key key{event.name, event.control, event.shift, event.alt};
    bool copies = key.control && (key.name == "c" || key.name == "insert");
    if (copies && !prompt.edit().selecting() && views.log_view.selecting()) {
        clipboard->write(views.log_view.selected());
        return;
    }
    const bool listed = settings.flag("tweaks");
    const std::size_t before = log.lines().size() + log.dropped();
    if (prompt.key(key)) {
        status.edits_without_undo = property::edits_without_undo(tree);
        const bool printed = log.lines().size() + log.dropped() != before;
        if (key.name == "enter" || printed) views.log_view.scroll_to_end();
        // The output of a command is shown in place of the list that was there before.
        if (listed && printed) settings.set("tweaks", property::Value(false));
        if (printed) status.inspector_over_log = false;
        return;
    }
    if (key.control && key.name == "o") {
        if (const auto line = log.unfold_last()) views.log_view.scroll_to(*line);
        return;
    }
    if (key.name == "page_up" || key.name == "page_down")
        views.log_view.scroll_pages(key.name == "page_up" ? -1.0f : 1.0f);
    else if (key.name == "escape" && views.log_view.selecting())
        views.log_view.clear_selection();
    else if (key.name == "escape")
        open(false);
}

void Console::State::note_lost_undo() {
    const std::size_t now = property::edits_without_undo(tree);
    if (std::exchange(status.edits_without_undo, now) < now) log.note(property::no_undo_message);
}

// --- Mouse

bool Console::State::over_windows(float x, float y) const {
    return screen.popup_open || screen.panel_rect.contains(x, y) ||
           screen.inspector_rect.contains(x, y) || screen.height_edge.contains(x, y) ||
           screen.width_edge.contains(x, y) || screen.plot_edge.contains(x, y) ||
           views.time_bar.rect().contains(x, y) || views.watch_list.rect().contains(x, y) ||
           views.plot_view.rect().contains(x, y) || views.frame_view.rect().contains(x, y) ||
           views.compare_view.rect().contains(x, y) || views.prompt_view.menu_rect().contains(x, y);
}

bool Console::State::mouse(const InputEvent& event) {
    bool over = status.was_open && over_windows(event.x, event.y);
    switch (event.kind) {
        case EventKind::mouse_moved:
            if (input.box) {
                input.box->to_x = event.x;
                input.box->to_y = event.y;
                return true;
            }
            feed(event);
            return input.buttons.any_of_console() || (over && !input.buttons.any_of_game());
        case EventKind::wheel:
            if (over) feed(event);
            return over;
        case EventKind::mouse_pressed:
            input.keys_to_selection = false;
            inspector.editor().fields().unfocus_widget();
            // Ctrl+Z takes back what is edited with the mouse, and no text that was deleted before.
            if (prompt.edit().empty()) prompt.edit().clear_steps();
            if (over) {
                input.buttons.press(event.name, HeldKeys::Owner::console);
                feed(event);
                return true;
            }
            if (click_paused_sign(event)) {
                input.buttons.press(event.name, HeldKeys::Owner::console);
                return true;
            }
            if (status.was_open && (event.name == "left" || event.name == "right") &&
                options.to_world && settings.flag("picks") &&
                click_game(event.x, event.y, event.name == "right")) {
                input.buttons.press(event.name, HeldKeys::Owner::console);
                return true;
            }
            input.buttons.press(event.name, HeldKeys::Owner::game);
            return false;
        default:
            break;
    }
    if (event.name == "left" && input.box) end_box();
    HeldKeys::Owner owner = input.buttons.release(event.name);
    if (owner == HeldKeys::Owner::game) return false;
    feed(event);
    return owner == HeldKeys::Owner::console || over;
}

void Console::State::end_box() {
    const DrawnBox drawn = *std::exchange(input.box, std::nullopt);
    try {
        const std::vector<property::Handle> inside =
            in_box(tree, options.to_world(drawn.from_x, drawn.from_y),
                   options.to_world(drawn.to_x, drawn.to_y));
        if (inside.empty()) return;
        choose_all(inside);
        input.keys_to_selection = true;
    } catch (const std::exception& error) {
        log.error(property::exception_text(error));
    }
}

bool Console::State::selection_key(const InputEvent& event) {
    if (!input.keys_to_selection || !options.to_world) return false;
    const std::vector<property::Handle> all = inspector.selection();
    if (all.empty() || event.name.ends_with("_shift") || event.name.ends_with("_control"))
        return false;
    property::Vec2 pixels(0, 0);
    if (event.name == "left") pixels.x = -1;
    if (event.name == "right") pixels.x = 1;
    if (event.name == "up") pixels.y = -1;
    if (event.name == "down") pixels.y = 1;
    const bool moves = pixels != property::Vec2(0, 0) && !event.control;
    if (moves) {
        if (event.shift) pixels *= 10;
        const auto x = static_cast<float>(pixels.x), y = static_cast<float>(pixels.y);
        try {
            move_by(tree, all, options.to_world(x, y) - options.to_world(0, 0));
        } catch (const std::exception& error) {
            log.error(property::exception_text(error));
        }
        return true;
    }
    if (event.name == "delete" && prompt.edit().text().empty()) {
        inspector.delete_selection();
        return true;
    }
    input.keys_to_selection = false;  // the person types
    return false;
}

/// The game never gets the left button here, and gets the right button only where nothing is.
bool Console::State::click_game(float x, float y, bool menu) {
    if (!menu && input.shift_held) {
        input.box = DrawnBox{x, y, x, y};
        return true;
    }
    try {
        property::Handle found = pick_widget(tree, {x, y});
        if (!found) found = pick(tree, options.to_world(x, y));
        if (!found && options.to_pixels)
            found = pick_picture(tree, {x, y}, options.to_pixels, seen());
        if (!found) {
            if (!menu) input.keys_to_selection = tree.alive(inspector.selected());
            return !menu;
        }
        input.keys_to_selection = true;
        if (!menu) status.inspector_over_log = true;
        if (!menu && input.control_held) {
            inspector.toggle(found);
            choose_all(inspector.selection());
            return true;
        }
        const std::vector<property::Handle> all = inspector.selection();
        // A menu that is opened on a selected instance is for the whole selection.
        if (!menu || std::ranges::find(all, found) == all.end())
            inspector.select(std::vector{found});
        choose(found);
        if (menu) context_menu.open(tree.path(found));
    } catch (const std::exception& error) {
        log.error(property::exception_text(error));
    }
    return true;
}

// --- To widgets

void Console::State::feed(const InputEvent& event) {
    bool key = event.kind == EventKind::key_pressed || event.kind == EventKind::key_released;
    bool text = event.kind == EventKind::text;
    // A widget that is dragged follows the mouse only in frames in which the button is down.
    bool ends_drag = input.fed_move && event.kind == EventKind::mouse_released;
    bool separate = input.fed_button || input.fed_key || (input.fed_text && !text) || ends_drag;
    if (separate && status.was_open) frame(0);
    // A field that has just got the keyboard takes no shortcut, such as Escape, in its next frame.
    ui.activate();
    if (key && status.was_open && compat::keyboard_moved()) frame(0);
    input.fed_key = input.fed_key || key;
    input.fed_text = input.fed_text || text;
    input.fed_move = input.fed_move || event.kind == EventKind::mouse_moved;
    input.fed_button = input.fed_button || event.kind == EventKind::mouse_pressed ||
                       event.kind == EventKind::mouse_released;
    ui.feed(event);
}

}  // namespace fettle::console
