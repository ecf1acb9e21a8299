#include <layout/layout.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace fettle::interface {

using property::Handle;
using property::Row;
using property::Vec2;

namespace {

constexpr int deepest = 100;  // widgets in each other; those below are not shown

/// `z` of the instance and of all above it.
double z_of(const property::Tree& tree, Handle instance) {
    static const property::Symbol name("z");
    double z = 0;
    for (; instance; instance = tree.parent(instance))
        if (const property::Property* of = tree.find(instance, name))
            if (const property::Value value = tree.peek(instance, *of); value.is_numeric())
                z += value.as_double();
    return z;
}

}  // namespace

void Layout::update(const Vec2& screen) {
    const double shorter = std::min(screen.x, screen.y);
    const double scale =
        widgets_.board.scale > 0 ? widgets_.board.scale : std::clamp(shorter / 720, 0.5, 8.0);
    if (screen != screen_ || scale != scale_) widgets_.stale = true;
    if (!widgets_.stale) return sort_tops();
    widgets_.stale = false;
    screen_ = screen;
    scale_ = widgets_.scale = scale;
    ++count_;
    collect();
    const Box all{{0, 0}, screen_ / scale_};
    for (const Widget& widget : widgets_)
        if (widget.self && widget.arranged.shown) load_font(widget);
    for (const Row top : tops_) {
        measure(top, all.width());
        Widget screen_panel;
        screen_panel.arranged.children = {top};
        arrange_panel(screen_panel, all, all);
    }
    order_.clear();
    shown_.clear();
    sort_tops();
}

// --- Which widgets there are

void Layout::collect() {
    const property::Tree& tree = widgets_.tree();
    tops_.clear();
    for (Widget& widget : widgets_) {
        widget.arranged.children.clear();
        widget.arranged.shown = false;
        widget.arranged.look_of = &widgets_.themes.plain;
    }
    const Handle fallback =
        tree.alive(widgets_.service()) ? tree.child(widgets_.service(), "theme") : Handle{};
    const Theme& common = fallback && tree.class_of(fallback).is_a(widgets_.themes.of())
                              ? widgets_.themes[tree.row(fallback)]
                              : widgets_.themes.plain;
    for (Widget& widget : widgets_) {
        if (!widget.self || widgets_.is_widget(tree.parent(widget.self))) continue;
        Handle above = widget.self;
        while (tree.parent(above)) above = tree.parent(above);
        const Row row = tree.row(widget.self);
        const bool placed = above == tree.root();
        collect_below(row, no_widget, theme_of(widget, common), placed && widget.visible, 0);
        if (placed) tops_.push_back(row);
    }
    if (tops_.size() < 2) return;
    // Rows are used again, so their order is not that of the tree.
    if (std::exchange(widgets_.moved, false)) {
        places_.clear();
        std::size_t n = 0;
        tree.each_below(tree.root(), [&](Handle each) {
            if (widgets_.is_widget(each)) places_[tree.row(each)] = n++;
        });
    }
    std::sort(tops_.begin(), tops_.end(), [this](Row a, Row b) { return places_[a] < places_[b]; });
}

void Layout::collect_below(Row row, Row parent, const Theme& theme, bool shown, int depth) {
    Widget& widget = widgets_[row];
    widget.arranged.parent = parent;
    widget.arranged.look_of = &theme;
    widget.arranged.shown = shown && depth < deepest;
    const property::Tree& tree = widgets_.tree();
    for (Handle child = tree.first_child(widget.self); child; child = tree.next_sibling(child)) {
        if (!widgets_.is_widget(child)) continue;
        const Row below = tree.row(child);
        Widget& one = widgets_[below];
        if (is_container(widget.kind) && widget.arranged.shown && one.visible &&
            depth + 1 < deepest)
            widget.arranged.children.push_back(below);
        if (depth < 2 * deepest)
            collect_below(below, row, theme_of(one, theme),
                          widget.arranged.shown && one.visible && is_container(widget.kind),
                          depth + 1);
    }
}

/// A message about a missing font names the widget or the theme that has it.
void Layout::load_font(const Widget& widget) {
    const Handle user = widget.style.font.empty() ? widget.arranged.look_of->self : widget.self;
    const auto path = [&tree = widgets_.tree(), &user] {
        return user ? tree.path(user) + ".font" : std::string("interface.theme.font");
    };
    media_.load_font(path, Lettering::of(widget).font);
}

const property::Picture& Layout::picture_of(const Widget& widget) const {
    const auto user = [this, &widget] { return widgets_.tree().path(widget.self) + ".image"; };
    return media_.picture(user, widget.content.image);
}

const Theme& Layout::theme_of(const Widget& widget, const Theme& above) {
    const property::Tree& tree = widgets_.tree();
    if (!widget.style.theme || !tree.alive(widget.style.theme) ||
        !tree.class_of(widget.style.theme).is_a(widgets_.themes.of()))
        return above;
    return widgets_.themes[tree.row(widget.style.theme)];
}

/// Later ones are drawn over earlier ones, unless their `z` says otherwise.
void Layout::sort_tops() {
    std::vector<double> order;
    for (const Row top : tops_) order.push_back(z_of(widgets_.tree(), widgets_[top].self));
    if (order == order_) return;
    std::vector<std::size_t> by(tops_.size());
    std::iota(by.begin(), by.end(), 0);
    std::stable_sort(by.begin(), by.end(),
                     [&](std::size_t a, std::size_t b) { return order[a] < order[b]; });
    const std::vector<Row> before = tops_;
    order_.clear();
    for (std::size_t i = 0; i < by.size(); ++i) {
        tops_[i] = before[by[i]];
        order_.push_back(order[by[i]]);
    }
    shown_.clear();
    const auto add = [this](const auto& self, Row row) -> void {
        if (!widgets_[row].arranged.shown) return;
        shown_.push_back(row);
        for (const Row child : widgets_[row].arranged.children) self(self, child);
    };
    for (const Row top : tops_) add(add, top);
}

// --- Lengths

double Layout::padding_of(const Widget& widget) {
    if (widget.placing.padding) return *widget.placing.padding;
    return widget.kind == Kind::panel  ? widget.arranged.look_of->padding
           : widget.kind == Kind::list ? 5
                                       : 0;
}

double Layout::spacing_of(const Widget& widget) {
    return widget.placing.spacing.value_or(widget.kind == Kind::list &&
                                                   !widget.content.items.empty()
                                               ? 2
                                               : widget.arranged.look_of->spacing);
}

double Layout::line_of(const Widget& list) {
    return std::round(Lettering::of(list).line_height() + 10);
}

Box Layout::inside(const Widget& list) {
    return list.arranged.box.smaller(padding_of(list));
}

double Layout::scrolled(const Widget& list) {
    return std::clamp(list.content.scroll, 0.0,
                      std::max(0.0, list.arranged.content_height - inside(list).height()));
}

/// Edges lie on whole pixels of the screen, so that they are sharp.
Box Layout::snapped(const Box& box) const {
    const auto whole = [this](const Vec2& p) {
        return Vec2(std::round(p.x * scale_) / scale_, std::round(p.y * scale_) / scale_);
    };
    const Vec2 lower = whole(box.lower);
    return {lower, lower.max(whole(box.upper))};
}

}  // namespace fettle::interface
