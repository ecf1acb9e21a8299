#include <fettle/app/error_screen.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include <fettle/app/filled_box.h>
#include <fettle/property/utf8.h>

namespace fettle::app {

namespace {

constexpr SurfaceColor white{240, 242, 246, 255};
constexpr SurfaceColor pale{150, 158, 172, 255};
constexpr SurfaceColor red{255, 112, 104, 255};
constexpr SurfaceColor amber{255, 205, 120, 255};
constexpr SurfaceColor green{166, 218, 149, 255};

constexpr int steps_a_key = 6;       // of the arrows that go through the past
constexpr float widest_margin = 48;  // px
constexpr float small_margin = 16;   // px, below another layer
constexpr float small_width = 640;   // px; texts and margins are smaller in narrower windows
constexpr float keys_height = 44;    // px, of the bar with the keys

/// Of the texts, at both sides, px.
float margin_in(const Surface& surface) {
    return std::clamp(widest_margin * surface.width() / small_width, small_margin, widest_margin);
}

/// Factor of the size of large texts.
float scale_in(const Surface& surface) {
    return std::clamp(surface.width() / small_width, 0.8f, 1.0f);
}

/// Width of the text in a part of the surface, px.
float text_width(const Surface& surface, const ClipRectangle& part) {
    return std::max(100.0f, part.width - 2 * margin_in(surface));
}

/// Length of the part of `text` that fits `width` pixels; it ends after a space if there is one.
std::size_t fitting(Surface& surface, std::string_view text, float width, float size, Face face) {
    const auto fits = [&](std::size_t length) {
        return surface.text(0, 0, text.substr(0, length), size, {0, 0, 0, 0}, face) <= width;
    };
    if (fits(text.size())) return text.size();
    std::size_t low = 1, high = text.size();
    while (low + 1 < high) {
        const std::size_t middle = (low + high) / 2;
        (fits(middle) ? low : high) = middle;
    }
    // Do not cut inside a character of several bytes.
    low = std::max<std::size_t>(1, property::code_point_boundary(text, low));
    const std::size_t space = text.substr(0, low).rfind(' ');
    return space == std::string_view::npos || space < low / 2 ? low : space + 1;
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        std::string spaced;
        for (const char c : line) c == '\t' ? spaced += "    " : spaced += c;
        lines.push_back(std::move(spaced));
    }
    return lines;
}

std::string place_of(const script::ScriptError& error) {
    if (error.file.empty()) return {};
    return error.line > 0 ? error.file + ":" + std::to_string(error.line) : error.file;
}

}  // namespace

struct ErrorScreen::Line {
    std::string text{};
    float size = 15;  // px
    SurfaceColor color = white;
    Face face = Face::plain;
    float above = 0;         // px, space above the line
    bool boxed = false;      // code, on a darker background
    int caret = -1;          // the character that a caret below the line points to
    std::size_t indent = 0;  // of the rows after the first one, in characters
    bool heading = false;    // of the lines below it
    bool continues = false;  // the line before it
    bool below = false;      // a caret
};

std::string error_text(const script::ScriptError& error) {
    std::ostringstream out;
    out << "error";
    if (!error.context.empty()) out << " in " << error.context;
    out << ": " << error.message << '\n';
    if (!error.source_line.empty()) {
        const std::string number = std::to_string(error.line);
        out << "  " << number << " | " << error.source_line << '\n';
        if (error.column > 0)
            out << "  " << std::string(number.size(), ' ') << " | "
                << std::string(static_cast<std::size_t>(error.column - 1), ' ') << "^\n";
    }
    const auto section = [&](const char* title, const std::string& text) {
        if (text.empty()) return;
        out << title << '\n';
        for (const std::string& line : split(text)) out << "  " << line << '\n';
    };
    section("traceback:", error.traceback);
    section("local variables:", error.locals);
    return out.str();
}

void ErrorScreen::show(const script::ScriptError& error) {
    if (error_) {
        ++further_errors_;
        return;
    }
    error_ = error;
    further_errors_ = 0;
    scroll_ = 0;
}

void ErrorScreen::show_running(const script::LongCall& call) {
    if (!running_) scroll_ = 0;
    running_ = call;
}

void ErrorScreen::script_returned() {
    running_.reset();
    stop_wanted_ = waits_ = false;
}

namespace {

/// Adds the place of the error and its source line.
template <class Line>
void add_source(std::vector<Line>& lines, const script::ScriptError& e) {
    const std::string place = place_of(e);
    if (!place.empty()) lines.push_back({.text = place, .color = pale, .above = 18});
    if (e.source_line.empty()) return;
    const std::string prefix = (e.line > 0 ? std::to_string(e.line) : std::string()) + "  ";
    lines.push_back({.text = prefix + e.source_line,
                     .size = 16,
                     .color = amber,
                     .face = Face::monospace,
                     .above = 6,
                     .boxed = true,
                     .caret = e.column > 0 ? static_cast<int>(prefix.size()) + e.column - 1 : -1,
                     .indent = prefix.size()});
}

/// How many bytes of the text are in its first row: as many as there is room for, but no part of a
/// word, unless a word takes half of the row.
template <class Line>
std::size_t first_row(Surface& surface, std::string_view text, float room, const Line& line) {
    const std::size_t fits = fitting(surface, text, room, line.size, line.face);
    if (fits == text.size()) return fits;
    const std::size_t blank = text.substr(0, fits).rfind(' ');
    return blank == std::string_view::npos || blank < fits / 2 ? fits : blank + 1;
}

/// The lines in pieces that are as wide as `room` at most. A caret is below its piece.
template <class Line>
std::vector<Line> broken(Surface& surface, const std::vector<Line>& lines, float room) {
    std::vector<Line> pieces;
    for (const Line& line : lines) {
        int begin = 0;  // character of the line
        std::string_view rest = line.text;
        do {
            Line piece = line;
            const std::string indent(begin > 0 ? line.indent : 0, ' ');
            const float inside =
                room - surface.text(0, 0, indent, line.size, {0, 0, 0, 0}, line.face);
            const std::string_view part = rest.substr(0, first_row(surface, rest, inside, line));
            rest.remove_prefix(part.size());
            piece.text = indent + std::string(part);
            if (begin > 0) piece.above = 0;
            piece.continues = begin > 0;
            const int end = begin + static_cast<int>(property::code_point_count(part));
            pieces.push_back(std::move(piece));
            if (line.caret >= begin && (line.caret < end || rest.empty())) {
                Line caret = line;
                caret.text =
                    indent + std::string(static_cast<std::size_t>(line.caret - begin), ' ') + "^";
                caret.color = red;
                caret.above = 0;
                caret.below = true;
                pieces.push_back(std::move(caret));
            }
            begin = end;
        } while (!rest.empty());
    }
    return pieces;
}

/// The text of a row after which others are left out.
template <class Line>
std::string ended(Surface& surface, const Line& line, float room) {
    constexpr std::string_view more = "…";
    const float left = room - surface.text(0, 0, more, line.size, {0, 0, 0, 0}, line.face);
    std::string_view text = line.text;
    text = text.substr(0, fitting(surface, text, left, line.size, line.face));
    while (text.ends_with(' ')) text.remove_suffix(1);
    return std::string(text) + std::string(more);
}

template <class Line>
void add_section(std::vector<Line>& lines, const char* title, const std::string& text,
                 SurfaceColor color) {
    if (text.empty()) return;
    lines.push_back({.text = title, .color = pale, .above = 18, .heading = true});
    for (std::string& line : split(text))
        lines.push_back({.text = std::move(line),
                         .size = 14,
                         .color = color,
                         .face = Face::monospace,
                         .above = 1});
}

std::string in_seconds(double seconds) {
    char text[32];
    std::snprintf(text, sizeof text, "%.0f s", seconds);
    return text;
}

}  // namespace

std::vector<ErrorScreen::Line> ErrorScreen::lines_of_error() const {
    std::vector<Line> lines;
    const script::ScriptError& e = *error_;
    lines.push_back({.text = "The game stopped at an error" +
                             (e.context.empty() ? std::string() : " in " + e.context),
                     .size = 16,
                     .color = pale});
    lines.push_back({.text = e.message, .size = 21, .color = red, .face = Face::bold, .above = 8});
    if (!e.source_line.empty()) add_source(lines, e);
    add_section(lines, "Called from", e.traceback, white);
    add_section(lines, "Local variables", e.locals, green);
    if (further_errors_ > 0)
        lines.push_back(
            {.text = std::to_string(further_errors_) + " more since", .color = pale, .above = 18});
    return lines;
}

std::vector<ErrorScreen::Line> ErrorScreen::lines_of_running() const {
    std::vector<Line> lines;
    const script::ScriptError& where = running_->where;
    lines.push_back({.text = "The game waits while this script runs", .size = 16, .color = pale});
    lines.push_back({.text = (waits_ ? "Waiting for " : "No answer from ") + place_of(where) +
                             " for " + in_seconds(running_->seconds),
                     .size = 21,
                     .color = amber,
                     .face = Face::bold,
                     .above = 8});
    if (waits_) return lines;
    add_source(lines, where);
    add_section(lines, "Called from", where.traceback, white);
    add_section(lines, "Local variables", where.locals, green);
    return lines;
}

std::vector<ErrorScreen::Line> ErrorScreen::lines() const {
    return running_ ? lines_of_running() : lines_of_error();
}

/// Handles a key that has an action.
bool ErrorScreen::handle_key(const std::string& key) {
    if (key == "r" && actions_.reload) {
        stop_wanted_ = running_.has_value();
        actions_.reload();
    } else if (running_) {
        stop_wanted_ = stop_wanted_ || key == "s";
        waits_ = waits_ || key == "w";
    } else if (key == "c" && actions_.copy) {
        actions_.copy(error_text(*error_));
    } else if (key == "escape" && actions_.go_on) {
        hide();
        actions_.go_on();
    }
    return true;
}

bool ErrorScreen::handle(const InputEvent& event) {
    if (!visible()) return false;
    switch (event.kind) {
        case EventKind::key_pressed:
            if (event.name == "up") scroll_ = std::max(0, scroll_ - 1);
            if (event.name == "down") ++scroll_;
            if (event.name == "page_up") scroll_ = std::max(0, scroll_ - 10);
            if (event.name == "page_down") scroll_ += 10;
            // These keys repeat while they are held.
            if (!running_ && actions_.travel && (event.name == "left" || event.name == "right")) {
                actions_.travel(event.name == "left" ? -steps_a_key : steps_a_key);
                return true;
            }
            return event.repeated || handle_key(event.name);
        case EventKind::wheel:
            scroll_ = std::max(0, scroll_ - static_cast<int>(3 * event.delta));
            return true;
        case EventKind::resized:
        case EventKind::focus:
        case EventKind::closing:
            return false;
        default:
            return true;  // the game must get no input
    }
}

void ErrorScreen::draw(Surface& surface, double) {
    const float width = surface.width(), height = surface.height();
    const float low = height - (actions_.covered_below ? actions_.covered_below() : 0);
    strip_top_ = std::numeric_limits<float>::infinity();
    if (!visible()) {
        if (over_) strip_top_ = draw_over(surface, low);
        return;
    }
    if (!running_ && actions_.viewing_past && actions_.viewing_past()) {
        strip_top_ = draw_strip(surface, low);
        return;
    }
    fill(surface, 0, 0, width, height, {18, 20, 26, 238});
    fill(surface, 0, 0, 5, height, running_ ? amber : red);
    draw_text(surface, low - keys_height);
    draw_keys(surface, low - keys_height);
}

/// What is above the strip at the lower edge.
ClipRectangle ErrorScreen::free_area(const ClipRectangle& whole) const {
    const float low = std::min(whole.top + whole.height, strip_top_);
    return {whole.left, whole.top, whole.width, std::max(0.0f, low - whole.top)};
}

/// The part of the surface that no other layer covers.
ClipRectangle ErrorScreen::free_part(const Surface& surface) const {
    const ClipRectangle whole{0, 0, surface.width(), surface.height()};
    return actions_.free_area ? actions_.free_area(whole) : whole;
}

/// Draws the lines in the free part of the surface and above `bottom`, as many as there is room
/// for.
void ErrorScreen::draw_text(Surface& surface, float bottom) {
    const ClipRectangle part = free_part(surface);
    const float room = text_width(surface, part);
    bottom = std::min(bottom, part.top + part.height);
    const float margin = margin_in(surface);
    std::vector<Line> unbroken = lines();
    for (Line& line : unbroken)
        if (line.size > 16) line.size = std::round(line.size * scale_in(surface));
    std::vector<Line> all = broken(surface, unbroken, room);
    scroll_ = std::clamp(scroll_, 0, static_cast<int>(all.size()) - 1);
    float y = part.top + (part.top > 0 ? small_margin : margin);
    for (std::size_t i = static_cast<std::size_t>(scroll_); i < all.size() && y < bottom; ++i) {
        Line& line = all[i];
        const float step = 1.32f * line.size;
        y += line.above;
        if (y + step > bottom) break;
        // A heading has a row below it, and a text does not seem to end where it goes on.
        float low = y + step;
        std::size_t next = i + 1;
        for (; next < all.size() && all[next].below; ++next) low += 1.32f * all[next].size;
        if (next < all.size() && low + all[next].above + 1.32f * all[next].size > bottom) {
            if (line.heading) break;
            if (all[next].continues && !line.below) line.text = ended(surface, line, room);
        }
        if (line.boxed) fill(surface, margin - 10, y - 2, room + 20, step + 4, {8, 9, 12, 255});
        surface.text(margin, y, line.text, line.size, line.color, line.face);
        y += step;
    }
}

/// The keys that work now, and what they do.
std::vector<std::string> ErrorScreen::keys() const {
    const std::string key = actions_.console_key ? actions_.console_key() : std::string();
    if (actions_.console_is_open && actions_.console_is_open())
        return {key + "  close the console, for the keys of this screen"};
    std::vector<std::string> all = {"R  reload", "Esc  go on", "C  copy"};
    if (running_ && waits_)
        all = {"S  stop it", "R  reload"};
    else if (running_)
        all = {"S  stop it", "W  wait on", "R  reload"};
    if (!key.empty()) all.push_back(key + "  console");
    if (!running_) all.emplace_back("\u2190 \u2192  back in time");
    if (!running_ || !waits_) all.emplace_back("\u2191 \u2193  scroll");
    return all;
}

/// Draws the keys in a bar, `bottom` being its upper edge. In a narrow window they are closer
/// together and smaller.
void ErrorScreen::draw_keys(Surface& surface, float bottom) const {
    fill(surface, 0, bottom + 4, surface.width(), keys_height - 4, {10, 11, 15, 255});
    constexpr float size = 14, least_size = 9;
    const float margin = margin_in(surface);
    const auto drawn = [&](std::size_t gap, float left, float letters, SurfaceColor color) {
        std::string line;
        for (const std::string& key : keys())
            line += (line.empty() ? "" : std::string(gap, ' ')) + key;
        return surface.text(left, bottom + 16, line, letters, color, Face::plain);
    };
    constexpr SurfaceColor unseen{0, 0, 0, 0};
    for (const std::size_t gap : {6u, 3u})
        if (drawn(gap, 0, size, unseen) <= surface.width() - margin - small_margin) {
            drawn(gap, margin, size, pale);
            return;
        }
    constexpr std::size_t least_gap = 2;
    const float room = surface.width() - 2 * small_margin;
    const float fitting_size = std::floor(size * room / drawn(least_gap, 0, size, unseen));
    drawn(least_gap, small_margin, std::clamp(fitting_size, least_size, size), pale);
}

/// Draws the error that does not stop the game at the lower edge.
float ErrorScreen::draw_over(Surface& surface, float bottom) const {
    const script::ScriptError& e = *over_;
    std::vector<Line> all = {
        {.text = heading_over_, .size = 14, .color = pale},
        {.text = e.message, .size = 17, .color = red, .face = Face::bold, .above = 4}};
    if (!e.source_line.empty()) add_source(all, e);
    const float room = text_width(surface, free_part(surface));
    const std::vector<Line> lines = broken(surface, all, room);
    float needed = 24;
    for (const Line& line : lines) needed += line.above + 1.32f * line.size;
    const float top = std::max(0.0f, bottom - needed);
    fill(surface, 0, top, surface.width(), bottom - top, {18, 20, 26, 255});
    fill(surface, 0, top, 5, bottom - top, red);
    float y = top + 12;
    for (const Line& line : lines) {
        y += line.above;
        surface.text(margin_in(surface), y, line.text, line.size, line.color, line.face);
        y += 1.32f * line.size;
    }
    return top;
}

/// Draws the message of the error and the keys; the game stays visible above.
float ErrorScreen::draw_strip(Surface& surface, float bottom) const {
    constexpr std::size_t most_rows = 3;
    const float room = text_width(surface, free_part(surface));
    const std::vector<Line> headline = {
        {.text = error_->message, .size = 16, .color = red, .face = Face::bold}};
    std::vector<Line> rows = broken(surface, headline, room);
    if (rows.size() > most_rows) {
        rows.resize(most_rows);
        rows.back().text = ended(surface, rows.back(), room);
    }
    const float row = 1.32f * 16, tall = 17 + row * static_cast<float>(rows.size());
    const float top = bottom - keys_height - tall + 4;
    fill(surface, 0, top, surface.width(), tall, {18, 20, 26, 255});
    fill(surface, 0, top, 5, tall + keys_height, red);
    float y = top + 8;
    for (const Line& line : rows) {
        surface.text(margin_in(surface), y, line.text, line.size, line.color, line.face);
        y += row;
    }
    draw_keys(surface, bottom - keys_height);
    return top;
}

}  // namespace fettle::app
