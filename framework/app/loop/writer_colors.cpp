#include <loop/writer_colors.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include <fettle/app/filled_box.h>
#include <fettle/property/drawing.h>
#include <fettle/property/earlier_writer.h>
#include <fettle/property/utf8.h>

#include <loop/tint_painter.h>

namespace fettle::app {

using property::Color;
using property::Handle;
using property::Tree;
using property::Vec2;
using property::Writer;

namespace {

constexpr Color physics_color{0.55f, 0.6f, 0.7f, 1};
constexpr Color unknown_color{0.3f, 0.3f, 0.32f, 1}, others_color{0.85f, 0.85f, 0.85f, 1};
constexpr std::array<Color, 10> colors{{{0.95f, 0.45f, 0.35f, 1},
                                        {0.3f, 0.75f, 1.0f, 1},
                                        {0.98f, 0.8f, 0.3f, 1},
                                        {0.5f, 0.85f, 0.45f, 1},
                                        {0.85f, 0.5f, 0.95f, 1},
                                        {1.0f, 0.6f, 0.75f, 1},
                                        {0.35f, 0.9f, 0.8f, 1},
                                        {0.85f, 0.65f, 0.45f, 1},
                                        {0.4f, 0.45f, 1.0f, 1},
                                        {0.6f, 0.62f, 0.15f, 1}}};
constexpr std::string_view physics = "physics", unknown = "unknown", others = "others";

using LatestWrites = std::unordered_map<std::uint64_t, property::Provenance>;

/// Sets `latest` to the last write of an instance, unless `latest` is later.
void find_latest_write(const LatestWrites& writes, Handle instance, property::Provenance& latest) {
    const auto found = writes.find(instance.key());
    if (found == writes.end()) return;
    if (!latest.known || found->second.cause.step >= latest.cause.step) latest = found->second;
}

bool is_moved(const Tree& tree, Handle instance) {
    const auto value = [&](const char* name) {
        const property::Property* const found = tree.find(instance, name);
        return found != nullptr ? tree.peek(instance, *found) : property::Value();
    };
    const property::Value awake = value("awake"), type = value("type");
    const bool is_static = type.is(property::Type::text) && type.text() == "static";
    return !is_static && awake.is(property::Type::boolean) && awake.boolean();
}

std::string writer_of(const Tree& tree, const LatestWrites& writes, Handle instance, double dt) {
    property::Provenance latest;
    find_latest_write(writes, instance, latest);
    tree.each_below(instance, [&](Handle below) { find_latest_write(writes, below, latest); });
    const auto second = static_cast<std::uint64_t>(std::max(1.0, 1 / std::max(dt, 1e-6)));
    const bool recent = latest.known && latest.cause.step + second > tree.step() &&
                        latest.cause.step <= tree.step();
    if (!recent && is_moved(tree, instance)) return std::string(physics);
    if (!latest.known) return std::string(unknown);
    const property::Cause& cause = latest.cause;
    const bool has_place = cause.writer == Writer::script && !cause.where.empty();
    return has_place ? cause.where : std::string(writer_name(cause.writer));
}

/// The writers and the number of instances that each wrote last, the largest number first.
using Legend = std::vector<std::pair<std::string, std::size_t>>;
Legend legend_of(const std::vector<InstanceWriter>& all) {
    std::map<std::string, std::size_t> counts;
    for (const InstanceWriter& each : all) ++counts[each.writer];
    Legend legend(counts.begin(), counts.end());
    std::ranges::stable_sort(legend,
                             [](const auto& a, const auto& b) { return a.second > b.second; });
    return legend;
}

/// Colors belong to writers, not to their rank. Writers beyond the number of colors have none.
std::map<std::string, Color> colors_of(const Legend& legend) {
    std::map<std::string, Color> found;
    std::array<bool, colors.size()> used{};
    for (const auto& [writer, count] : legend) {
        if (writer == physics || writer == unknown) {
            found[writer] = writer == physics ? physics_color : unknown_color;
            continue;
        }
        std::size_t at = 0;
        for (const char c : writer) at = at * 31 + static_cast<unsigned char>(c);
        std::size_t tries = 0;
        while (tries < colors.size() && used[(at + tries) % colors.size()]) ++tries;
        if (tries == colors.size()) continue;  // one of the others
        used[(at + tries) % colors.size()] = true;
        found[writer] = colors[(at + tries) % colors.size()];
    }
    return found;
}

}  // namespace

std::vector<InstanceWriter> instance_writers(const Tree& tree, double dt) {
    std::vector<InstanceWriter> all;
    const LatestWrites writes = property::latest_writes(tree);
    const auto visit = [&](const auto& self, Handle top) -> void {
        for (Handle each = tree.first_child(top); each; each = tree.next_sibling(each)) {
            const property::Property* const position = tree.find(each, "position");
            if (position != nullptr &&
                (position->type == property::Type::vec2 || position->any_type))
                all.push_back({each, writer_of(tree, writes, each, dt)});
            else
                self(self, each);
        }
    };
    visit(visit, tree.root());
    return all;
}

namespace {

/// Counts all writers without a color together, as the last ones.
void join_others(Legend& legend, const std::map<std::string, Color>& colored) {
    std::size_t rest = 0;
    std::erase_if(legend, [&](const auto& each) {
        const bool other = !colored.contains(each.first);
        if (other) rest += each.second;
        return other;
    });
    if (rest > 0) legend.emplace_back(others, rest);
}

}  // namespace

WriterColors::WriterColors(const Tree& tree, double dt)
    : tree_(tree),
      all_(instance_writers(tree, dt)),
      legend_(legend_of(all_)),
      color_(colors_of(legend_)) {
    join_others(legend_, color_);
}

Color WriterColors::color_of(const std::string& writer) const {
    const auto found = color_.find(writer);
    return found == color_.end() ? others_color : found->second;
}

namespace {

/// Gives each instance its color before it is drawn; those without one keep their own.
class Tints : public property::Drawer {
  public:
    Tints(const Tree& tree, TintPainter& painter) : tree_(tree), painter_(painter) {}
    void add(Handle instance, Color color) { colors_[instance.key()] = color; }
    bool draws(const property::Class&) override { return false; }
    bool begins(Handle instance) override {
        for (Handle at = instance; at; at = tree_.parent(at)) {
            const auto found = colors_.find(at.key());
            if (found == colors_.end()) continue;
            painter_.tint(found->second);
            return true;
        }
        painter_.keep_colors();
        return true;
    }
    void draw(Handle, property::Painter&) override {}

  private:
    const Tree& tree_;
    TintPainter& painter_;
    std::unordered_map<std::uint64_t, Color> colors_;
};

}  // namespace

void WriterColors::draw(property::Painter& painter, double alpha) const {
    TintPainter tinted(painter, unknown_color);
    Tints tints(tree_, tinted);
    for (const InstanceWriter& each : all_) {
        Color tint = color_of(each.writer);
        tint.a = 0.75f;
        tints.add(each.instance, tint);
    }
    // The whole tree, so that layers place what is in them, and nothing covers what is before it.
    const property::DrawingPart part(property::DrawingPart::Part::instances);
    tree_.draw(tree_.root(), tinted, alpha, &tints);
}

void WriterColors::draw_legend(Surface& surface, const ClipRectangle& room, float size) const {
    constexpr float usual_size = 15;
    const float scale = size > 0 ? size / usual_size : 1, text_size = usual_size * scale;
    const float row = 20 * scale, margin = 8 * scale, square = 14 * scale, gap = 10 * scale;
    constexpr SurfaceColor text_color{235, 237, 242, 255}, unseen{0, 0, 0, 0};
    const float rows = std::floor((room.height - 4 * margin) / row);
    const float text_room = room.width - 4 * margin - square - gap;
    if (rows < 1 || text_room <= 0) return;
    // Each color has a row as far as there is room: those of scripts, physics, unknown and others.
    const std::size_t most = std::min(colors.size() + 3, static_cast<std::size_t>(rows));
    const bool all = legend_.size() <= most;
    const auto named = static_cast<std::ptrdiff_t>(all ? legend_.size() : most - 1);
    Legend shown(legend_.begin(), legend_.begin() + named);
    if (!all) {
        std::size_t rest = 0;
        std::for_each(legend_.begin() + named, legend_.end(),
                      [&](const auto& each) { rest += each.second; });
        shown.emplace_back(named == 0 ? std::to_string(legend_.size()) + " writers" : others, rest);
    }
    const auto wide = [&](const std::string& text) {
        return surface.text(0, 0, text, text_size, unseen, Face::plain);
    };
    std::vector<std::string> lines;
    float widest = 0;
    for (const auto& [writer, count] : shown) {
        lines.push_back(writer + "   " + std::to_string(count));
        // The end of a path says more than its beginning.
        for (std::size_t cut = 1; wide(lines.back()) > text_room && cut < writer.size(); ++cut)
            if (!property::is_continuation(writer[cut]))
                lines.back() = "…" + writer.substr(cut) + "   " + std::to_string(count);
        widest = std::max(widest, wide(lines.back()));
    }
    const float left = room.left + 2 * margin;
    float y = room.top + room.height - 2 * margin - row * static_cast<float>(shown.size());
    fill(surface, left - margin, y - margin, widest + square + gap + 2 * margin,
         row * static_cast<float>(shown.size()) + 2 * margin, {15, 18, 26, 217});
    for (std::size_t i = 0; i < shown.size(); ++i, y += row) {
        const Color color = color_of(shown[i].first);
        const auto byte = [](float part) {
            return static_cast<std::uint8_t>(std::lround(part * 255));
        };
        fill(surface, left, y + 3 * scale, square, square,
             {byte(color.r), byte(color.g), byte(color.b), 255});
        surface.text(left + square + gap, y + scale, lines[i], text_size, text_color, Face::plain);
    }
}

}  // namespace fettle::app
