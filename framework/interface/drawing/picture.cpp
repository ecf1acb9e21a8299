#include <drawing/picture.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fettle::interface {

using property::Color;
using property::Row;
using property::TextAlign;
using property::Transform;
using property::Vec2;

// --- Gradual changes

void Picture::advance(double seconds) {
    constexpr double fade = 0.09;  // s
    const double part = 1 - std::exp(-std::clamp(seconds, 0.0, 1.0) / fade);
    time_ += seconds;
    const auto towards = [part](double& value, double to) {
        value += (to - value) * part;
        if (std::abs(to - value) < 0.004) value = to;
    };
    const Widget* const hovered = player_.hovered();
    for (const Row row : layout_.shown()) {
        Widget& widget = widgets_[row];
        if (!is_active(widget.kind)) continue;
        const bool held = widgets_.board.held == widget.self;
        const bool ringed = widgets_.board.focus == widget.self && widgets_.board.focus_shown;
        // A ring alone is hard to see beside a button in the accent color.
        const bool lit = held || ringed || &widget == hovered;
        towards(widget.animation.hover, lit && !widget.disabled ? 1 : 0);
        towards(widget.animation.press, held ? 1 : 0);
        towards(widget.animation.ring, ringed ? 1 : 0);
        if (widget.animation.switched < 0)
            widget.animation.switched = widget.content.on ? 1 : 0;
        else
            towards(widget.animation.switched, widget.content.on ? 1 : 0);
    }
}

// --- All widgets

void Picture::draw(property::Painter& painter, const Vec2& screen) {
    if (layout_.shown().empty()) return;
    painter_ = &painter;
    painter.begin_screen();
    painter.push(Transform::scaled(Vec2(widgets_.scale, widgets_.scale)));
    const Widget* shaded = nullptr;
    for (const Row row : layout_.shown())
        if (widgets_[row].modal && has_background(widgets_[row])) shaded = &widgets_[row];
    for (const Row row : layout_.shown()) {
        Widget& widget = widgets_[row];
        if (&widget == shaded) draw_shade(*widget.arranged.look_of, screen / widgets_.scale);
        double opacity = 1;
        bool enabled = true;
        for (const Widget* each = &widget;; each = &widgets_[each->arranged.parent]) {
            opacity *= each->style.opacity;
            enabled = enabled && !each->disabled;
            if (each->arranged.parent == no_widget) break;
        }
        const Box seen = widget.arranged.box.within(widget.arranged.clip);
        if (opacity <= 0 || seen.width() <= 0 || seen.height() <= 0) continue;
        painter.push({});
        const bool cut = widget.arranged.clip.lower.x > 0 || widget.arranged.clip.lower.y > 0 ||
                         widget.arranged.clip.upper.x * widgets_.scale < screen.x - 0.5 ||
                         widget.arranged.clip.upper.y * widgets_.scale < screen.y - 0.5;
        if (cut) painter.clip(widget.arranged.clip.lower, widget.arranged.clip.upper);
        if (opacity < 1) painter.fade(static_cast<float>(opacity));
        draw_widget(widget, enabled);
        painter.pop();
    }
    painter.pop();
    painter.end_screen();
    painter_ = nullptr;
}

void Picture::draw_widget(Widget& widget, bool enabled) {
    constexpr float pale = 0.42f;
    const bool container = is_container(widget.kind);
    if (!enabled && !container) painter_->fade(pale);
    if (widget.animation.ring > 0) draw_ring(widget);
    const Color ink = widget.style.text_color.value_or(widget.arranged.look_of->text);
    switch (widget.kind) {
        case Kind::panel:
        case Kind::row:
        case Kind::column:
            draw_background(widget);
            break;
        case Kind::list:
            draw_background(widget);
            if (!enabled) painter_->fade(pale);
            draw_list(widget);
            break;
        case Kind::button:
            draw_button(widget);
            break;
        case Kind::label:
            draw_lines(widget, widget.arranged.box, ink);
            break;
        case Kind::image:
            draw_image(widget, widget.arranged.box, widget.style.tint);
            break;
        case Kind::slider:
            draw_slider(widget);
            break;
        case Kind::toggle:
            draw_toggle(widget);
            break;
        case Kind::text_field:
            draw_field(widget);
            break;
        case Kind::progress_bar:
            draw_progress(widget);
            break;
    }
}

// --- Figures

void Picture::box(const Box& box, double radius, Color fill, Color border) {
    const double least = 0.5 * std::min(box.width(), box.height());
    if (least <= 0) return;
    const double r = std::clamp(radius, 0.0, least - 0.01);
    const Box core = box.smaller(r);
    const std::array<Vec2, 4> corners{core.lower, Vec2(core.upper.x, core.lower.y), core.upper,
                                      Vec2(core.lower.x, core.upper.y)};
    const float width = border.a > 0 ? static_cast<float>(std::max(1.0, widgets_.scale)) : 0;
    painter_->polygon(corners, r, {.fill = fill, .border = border, .border_width = width});
}

void Picture::disc(const Vec2& center, double radius, Color fill) {
    painter_->circle(center, radius, {.fill = fill, .border = none, .border_width = 0});
}

double Picture::radius_of(const Widget& widget) const {
    return widget.style.radius.value_or(widget.arranged.look_of->radius *
                                        (widget.kind == Kind::panel ? 1.6 : 1.0));
}

void Picture::draw_shade(const Theme& theme, const Vec2& screen) {
    box({{0, 0}, screen}, 0, theme.shade);
}

void Picture::draw_ring(const Widget& widget) {
    constexpr double gap = 2;
    Color color = widget.arranged.look_of->focus;
    color.a *= static_cast<float>(widget.animation.ring);
    const double most = 0.5 * std::min(widget.arranged.box.width(), widget.arranged.box.height());
    Box around = widget.arranged.box.smaller(-gap);
    double radius = std::min(radius_of(widget), most) + gap;
    if (widget.kind == Kind::slider || widget.kind == Kind::toggle) {
        around = widget.arranged.box.smaller(-3);
        radius = widget.arranged.look_of->radius + 3;
    }
    const double r =
        std::clamp(radius, 0.0, 0.5 * std::min(around.width(), around.height()) - 0.01);
    const Box core = around.smaller(r);
    const std::array<Vec2, 4> corners{core.lower, Vec2(core.upper.x, core.lower.y), core.upper,
                                      Vec2(core.lower.x, core.upper.y)};
    painter_->polygon(corners, r,
                      {.fill = none,
                       .border = color,
                       .border_width = static_cast<float>(std::max(2.0, 3 * widgets_.scale))});
}

void Picture::draw_background(const Widget& widget) {
    Color fill = none, border = none;
    if (widget.kind == Kind::panel)
        fill = widget.arranged.look_of->panel, border = widget.arranged.look_of->border;
    if (widget.kind == Kind::list)
        fill = widget.arranged.look_of->field, border = widget.arranged.look_of->border;
    if (widget.style.color) {
        fill = *widget.style.color;
        if (fill.a <= 0) border = none;
    }
    if (fill.a <= 0) return;
    const double radius = radius_of(widget);
    if (widget.kind == Kind::panel && widget.arranged.box.width() * widgets_.scale > 8) {
        // A soft shadow: several boxes, each a little larger.
        constexpr int layers = 8;
        for (int i = layers; i > 0; --i) {
            const double by = 2.5 * i;
            Box shadow = widget.arranged.box.smaller(-by);
            shadow.lower.y += 6, shadow.upper.y += 6;
            box(shadow, radius + by, {0, 0, 0, 0.035f * fill.a});
        }
    }
    box(widget.arranged.box, radius, fill, border);
}

// --- Texts and pictures

void Picture::draw_text(const Vec2& at, const std::string& text, const Widget& widget, Color color,
                        TextAlign align) {
    if (text.empty()) return;
    property::TextStyle style = Lettering::of(widget).style();
    style.color = color;
    style.align = align;
    layout_.media().text(*painter_, at, text, style);
}

void Picture::draw_lines(const Widget& widget, const Box& box, Color color) {
    const TextAlign align = widget.style.text_align == "left"    ? TextAlign::left
                            : widget.style.text_align == "right" ? TextAlign::right
                                                                 : TextAlign::middle;
    const double x = align == TextAlign::left    ? box.lower.x
                     : align == TextAlign::right ? box.upper.x
                                                 : box.center().x;
    const double height = Lettering::of(widget).line_height();
    double y =
        box.center().y - 0.5 * height * (static_cast<double>(widget.arranged.lines.size()) - 1);
    for (const std::string& line : widget.arranged.lines) {
        draw_text({x, y}, line, widget, color, align);
        y += height;
    }
}

void Picture::draw_image(const Widget& widget, const Box& box, Color tint) {
    if (widget.content.image.empty()) return;
    const property::Picture& picture = layout_.picture_of(widget);
    const Vec2 size(picture.width(), picture.height());
    if (size.smallest() <= 0) return;
    const Vec2 half = 0.5 * box.size().over(size).smallest() * size;
    painter_->picture(picture, {0, 0, size.x, size.y}, box.center() - half, box.center() + half,
                      tint, layout_.media().smooth());
}

}  // namespace fettle::interface
