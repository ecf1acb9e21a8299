#include <sprites/sprites.h>

#include <algorithm>
#include <bit>
#include <charconv>

#include <fettle/property/pose.h>
#include <fettle/property/spelling.h>

#include <properties/properties.h>

namespace fettle::visuals {

using property::Handle;
using property::Transform;
using property::Value;
using property::Vec2;

namespace {

/// The numbers of a text such as "3-6"; false for any other text.
bool read_range(const std::string& text, std::int64_t& first, std::int64_t& last) {
    const char* const end = text.data() + text.size();
    const auto begun = std::from_chars(text.data(), end, first);
    if (begun.ec != std::errc()) return false;
    last = first;
    if (begun.ptr == end) return true;
    if (*begun.ptr != '-') return false;
    const auto ended = std::from_chars(begun.ptr + 1, end, last);
    return ended.ec == std::errc() && ended.ptr == end;
}

std::string known_animations(const std::string& name, const Sheet& sheet) {
    std::vector<std::string> names;
    for (const Animation& each : sheet.animations) names.push_back(each.name);
    return property::suggestion(name, names);
}

}  // namespace

/// Null if it has no image.
const Sheet* Sprites::sheet(Row& row, const Reader& read) {
    const Value& name = read.in_place(of_.image);
    if (row.sheet == nullptr || !(name == row.name)) {
        row.name = name;
        const auto user = [this, &row] { return tree_->path(row.self, *of_.image); };
        row.sheet = row.name.text().empty() ? nullptr : images_.get(user, row.name.text());
    }
    return row.sheet.get();
}

// --- Frames

std::int64_t Sprites::frames_in(const Sheet& sheet, const Reader& read) const {
    if (!sheet.frames.empty()) return static_cast<std::int64_t>(sheet.frames.size());
    if (!sheet.found) return 1;
    // Most images have only one frame.
    if (read.in_place(of_.frame_size).is_nil())
        return read.integer(of_.columns) * read.integer(of_.rows);
    const FrameGrid all = grid(sheet, read);
    return all.columns * all.rows;
}

FrameGrid Sprites::grid(const Sheet& sheet, const Reader& read) const {
    const double margin = read.number(of_.margin), spacing = read.number(of_.spacing);
    const Value& size = read.in_place(of_.frame_size);
    return size.is_nil() ? FrameGrid::divided(sheet.picture, read.integer(of_.columns),
                                              read.integer(of_.rows), margin, spacing)
                         : FrameGrid::filled(sheet.picture, size.vec2(), margin, spacing);
}

Sprites::Playing Sprites::playing(const Row& row, const Sheet& sheet, const Reader& read) const {
    Playing all{.count = frames_in(sheet, read)};
    const std::string& name = read.in_place(of_.animation).text();
    if (name.empty() || !sheet.found) return all;
    if (const Animation* const found = sheet.animation(name))
        return {found, 0, static_cast<std::int64_t>(found->frames.size())};
    std::int64_t first = 0, last = 0;
    if (read_range(name, first, last) && first >= 1 && last >= first && last <= all.count)
        return {nullptr, first - 1, last - first + 1};
    const std::string what = row.name.text() + " has no animation \"" + name + "\"" +
                             known_animations(name, sheet) + "; it has " +
                             std::to_string(all.count) + (all.count == 1 ? " frame" : " frames");
    images_.report_once(what, [&] { return tree_->path(row.self, *of_.animation) + ": " + what; });
    return all;
}

/// The frame that is shown.
Frame Sprites::frame(const Row& row, const Reader& read) const {
    const Sheet& sheet = *row.sheet;
    if (sheet.frames.empty() && frames_in(sheet, read) == 1) return sheet.whole();
    const Playing plays = playing(row, sheet, read);
    const auto n = static_cast<std::size_t>(row.frame % plays.count);
    const std::size_t index =
        plays.animation ? plays.animation->frames[n] : static_cast<std::size_t>(plays.first) + n;
    if (!sheet.frames.empty()) return sheet.frames[index];
    return {grid(sheet, read).at(index)};
}

/// Time of the current frame; 0 if it does not go on.
double Sprites::seconds_of(const Row& row, const Sheet& sheet, const Playing& plays,
                           const Reader& read) const {
    const double rate = read.number(of_.frames_per_second);
    if (rate > 0) return 1 / rate;
    if (sheet.frames.empty()) return 0;
    const auto n = static_cast<std::size_t>(row.frame % plays.count);
    return sheet
        .frames[plays.animation ? plays.animation->frames[n]
                                : static_cast<std::size_t>(plays.first) + n]
        .seconds;
}

void Sprites::advance(Row& row, double dt) {
    const Reader read(*tree_, row.self);
    const Sheet* const shown = sheet(row, read);  // reports a missing file also if nothing is drawn
    if (shown == nullptr) return;
    // Most sprites have no animation.
    if (shown->frames.empty() && read.number(of_.frames_per_second) <= 0) return;
    const Playing plays = playing(row, *shown, read);
    if (plays.count < 2 || !read.flag(of_.playing)) return;
    // A file may give any length; the loop must end.
    constexpr double least_length = 1e-4;  // s
    const auto length_now = [&] {
        const double seconds = seconds_of(row, *shown, plays, read);
        return seconds > 0 ? std::max(seconds, least_length) : 0;
    };
    double length = length_now();
    if (length <= 0) return;
    const bool loop = read.flag(of_.loop);
    // At its end, an animation without `loop` stays for the whole time of its last frame.
    if (!loop && row.frame % plays.count == plays.count - 1 && row.elapsed >= length) return;
    row.elapsed += dt;
    // The tolerance makes six steps of 1/60 s a tenth of a second.
    while (row.elapsed + 1e-9 >= length && length > 0) {
        if (row.frame % plays.count == plays.count - 1 && !loop) {
            row.elapsed = length;
            ended_.push_back(row.self);
            return;
        }
        row.elapsed = std::max(0.0, row.elapsed - length);
        row.frame = (row.frame + 1) % plays.count;
        length = length_now();
    }
}

void Sprites::step(double dt) {
    ended_.clear();
    for (Row& row : rows_)
        if (row.self) advance(row, dt);
}

void Sprites::report() {
    // In an order that does not depend on the rows: a restore gives the same instances other rows.
    std::ranges::sort(ended_, {}, &Handle::index);
    for (const Handle self : ended_)
        if (tree_->alive(self) && tree_->listens(self, *finished_))
            tree_->emit(self, *finished_, {});
    ended_.clear();
}

std::uint64_t Sprites::hash() const {
    std::uint64_t hash = 0;
    const property::Class& sprite = tree_->class_named("Sprite");
    tree_->each_below(tree_->root(), [&](Handle instance) {
        if (!tree_->class_of(instance).is_a(sprite)) return;
        const Row& row = rows_[tree_->row(instance)];
        hash = (hash ^ static_cast<std::uint64_t>(row.frame)) * 0x9e3779b97f4a7c15u;
        hash = (hash ^ std::bit_cast<std::uint64_t>(row.elapsed)) * 0x9e3779b97f4a7c15u;
    });
    return hash;
}

// --- Drawing

Vec2 Sprites::size_of(const Frame& frame, bool on_screen, const Reader& read) const {
    const Value& given = read.in_place(of_.size);
    if (given.is(property::Type::vec2)) return given.vec2();
    return on_screen ? frame.size : Vec2(frame.size / read.number(of_.pixels_per_unit));
}

void Sprites::draw(Row& row, property::Painter& painter, double alpha) {
    const Reader read(*tree_, row.self);
    if (!read.flag(of_.visible) || sheet(row, read) == nullptr) return;
    const Frame shown = frame(row, read);
    const bool on_screen = painter.on_screen();
    const Vec2 size = size_of(shown, on_screen, read);
    if (size.x <= 0 || size.y <= 0 || shown.size.x <= 0 || shown.size.y <= 0) return;
    // The box of the uncut frame, and in it that of the part that the file contains.
    const Vec2 origin = read.vec2(of_.origin);
    const double unit_x = size.x / shown.size.x, unit_y = size.y / shown.size.y;
    double left = unit_x * shown.offset.x - size.x * origin.x;
    double right = left + unit_x * shown.area.width;
    // From the top of the frame down to the origin.
    double top = size.y * (1 - origin.y) - unit_y * shown.offset.y;
    double bottom = top - unit_y * shown.area.height;
    if (read.flag(of_.flip_x)) left = -left, right = -right;
    if (read.flag(of_.flip_y)) top = -top, bottom = -bottom;
    if (on_screen) top = -top, bottom = -bottom;
    painter.push(property::place_below(*tree_, row.self, on_screen, alpha).value_or(Transform()));
    const property::Blend blend = blend_of(read.in_place(of_.blend));
    if (blend != property::Blend::normal) painter.blend(blend);
    const Vec2 lower(left, on_screen ? top : bottom), upper(right, on_screen ? bottom : top);
    painter.picture(row.sheet->picture, shown.area, lower, upper, read.color(of_.tint),
                    read.flag(of_.smooth));
    painter.pop();
}

}  // namespace fettle::visuals
