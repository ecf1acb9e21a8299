#include <fettle/visuals/visuals.h>

#include <stdexcept>
#include <utility>

#include <fettle/property/ended_class.h>

#include <emitters/emitters.h>
#include <images/images.h>
#include <layers/layers.h>
#include <letters/fonts.h>
#include <letters/writing.h>
#include <lines/lines.h>
#include <sprites/sprites.h>
#include <texts/texts.h>
#include <tilemaps/tilemaps.h>

namespace fettle::visuals {

namespace {

Align align_of(property::TextAlign align) {
    return align == property::TextAlign::left    ? Align::left
           : align == property::TextAlign::right ? Align::right
                                                 : Align::center;
}

}  // namespace

/// Images and text for scripts that draw with a pen.
class GameMedia : public property::Media {
  public:
    GameMedia(Images& images, Fonts& fonts) : images_(images), fonts_(fonts) {}
    const property::Picture& picture(const property::FileUser& user,
                                     const std::string& name) override {
        return images_.get(user, name)->picture;
    }
    property::PictureFrame frame(const property::FileUser& user, const std::string& name,
                                 const property::ImageFrame& asked) override {
        const auto sheet = images_.get(user, name);
        const bool exported = !sheet->frames.empty();
        if (!exported && !sheet->found) return FrameGrid::divided(sheet->picture, 1, 1).at(0);
        const std::int64_t count =
            exported ? static_cast<std::int64_t>(sheet->frames.size()) : asked.columns * asked.rows;
        const auto index = static_cast<std::size_t>((asked.frame - 1) % count);
        if (exported) return sheet->frames[index];
        return FrameGrid::divided(sheet->picture, asked.columns, asked.rows).at(index);
    }
    void load_font(const property::FileUser& user, const std::string& font) override {
        (void)fonts_.get(user, font);
    }
    bool smooth() const override { return images_.smooth.value_or(true); }
    property::Vec2 text_size(std::string_view text, const property::TextStyle& style) override {
        const Layout layout = layout_of(text, style);
        return style.size * property::Vec2(layout.width, layout.height);
    }
    std::vector<double> carets(std::string_view text, const property::TextStyle& style) override {
        std::vector<double> places = Layout::carets(text, font_of(style));
        for (double& x : places) x *= style.size;
        return places;
    }
    bool right_to_left(std::string_view text) override { return Layout::right_to_left(text); }
    void text(property::Painter& painter, const property::Vec2& position, std::string_view text,
              const property::TextStyle& style) override {
        const Layout layout = layout_of(text, style);
        const double width = style.size * layout.width;
        const double left = style.align == property::TextAlign::left    ? 0
                            : style.align == property::TextAlign::right ? width
                                                                        : 0.5 * width;
        painter.push(property::Transform::moved(position));
        const property::Vec2 corner(-left, -0.5 * style.size * layout.height);
        constexpr double outline_width = 0.06;  // of the size, as that of Text
        if (style.outline.a > 0)
            draw_letters(painter, layout, style.size, corner, style.outline, outline_width);
        draw_letters(painter, layout, style.size, corner, style.color);
        painter.pop();
    }

  private:
    const Family& font_of(const property::TextStyle& style) {
        return fonts_.get([] { return std::string("pen.text"); }, style.font);
    }
    Layout layout_of(std::string_view text, const property::TextStyle& style) {
        return Layout::of(text, font_of(style), align_of(style.align),
                          style.size > 0 ? style.wrap / style.size : 0);
    }

    Images& images_;
    Fonts& fonts_;
};

struct Visuals::State {
    explicit State(property::Assets* assets)
        : images(assets),
          fonts(assets, [this](const std::string& problem) { images.report(problem); }),
          sprites(images),
          texts(fonts),
          tilemaps(images),
          emitters(images),
          media(images, fonts) {}
    Images images;
    Fonts fonts;
    Sprites sprites;
    Texts texts;
    Lines lines;
    Layers layers;
    Tilemaps tilemaps;
    Emitters emitters;
    GameMedia media;
    property::Tree* tree = nullptr;
    std::weak_ptr<const property::Tree*> tree_life;
};

Visuals::Visuals(property::Assets* assets) : state_(std::make_unique<State>(assets)) {}

// The classes are ended, because the tree would draw and read instances whose functions are gone.
Visuals::~Visuals() {
    if (state_->tree_life.expired()) return;
    state_->tree->remove_part(*this);
    for (const char* name : {"Tilemap", "TileLayer", "Emitter", "Sprite", "Text", "Line", "Layer"})
        property::end_class(*state_->tree, state_->tree->class_named(name));
}

void Visuals::renew(const std::string& name) {
    state_->images.renew(name);
    if (state_->fonts.renew(name)) state_->texts.clear_layouts();
    state_->tilemaps.renew(name);
}

void Visuals::attach(property::Tree& tree) {
    if (state_->tree != nullptr) throw std::logic_error("visuals are attached to a tree already");
    state_->tree = &tree;
    state_->sprites.define(tree);
    state_->texts.define(tree);
    state_->lines.define(tree);
    state_->layers.define(tree);
    state_->tilemaps.define(tree);
    state_->emitters.define(tree);
    tree.add_part(*this);
    state_->tree_life = tree.lifetime();
}

void Visuals::smooth_by_default(std::optional<bool> smooth) {
    state_->images.smooth = smooth;
}

void Visuals::saved_pictures(std::function<property::Thumbnail(const std::string& slot)> of) {
    state_->images.saved_pictures(std::move(of));
}

property::Media& Visuals::media() {
    return state_->media;
}

void Visuals::step(double dt) {
    state_->sprites.step(dt);
    state_->texts.step();
    state_->tilemaps.step(dt);
    state_->emitters.step(dt);
}

void Visuals::report(property::Tree&) {
    state_->sprites.report();
    state_->tilemaps.report();
    state_->emitters.report();
}

std::uint64_t Visuals::hash() const {
    return state_->sprites.hash() ^ 3 * state_->tilemaps.hash() ^ 5 * state_->emitters.hash();
}

property::Memory Visuals::save(property::ByteWriter& to) const {
    state_->emitters.save(to);
    return {};
}

std::function<void()> Visuals::restore(property::ByteReader& from, const property::Memory&) {
    return [this, emitters = state_->emitters.restore(from)] {
        emitters();
        state_->tilemaps.restored();
    };
}

void Visuals::on_problem(std::function<void(const std::string&)> listener) {
    state_->images.on_problem(std::move(listener));
}

}  // namespace fettle::visuals
