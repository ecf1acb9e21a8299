#pragma once
// The class Theme: colors, font and distances of widgets.

#include <deque>
#include <functional>
#include <string>

#include <fettle/module/rows.h>
#include <fettle/property/tree.h>

namespace fettle::interface {

struct Theme {
    property::Handle self{};
    property::Color panel{0.110f, 0.133f, 0.180f, 1};
    property::Color control{0.196f, 0.231f, 0.302f, 1};
    property::Color field{0.071f, 0.086f, 0.118f, 1};
    property::Color accent{0.184f, 0.435f, 0.929f, 1};
    property::Color text{0.945f, 0.957f, 0.976f, 1};
    property::Color muted{0.667f, 0.714f, 0.788f, 1};
    property::Color on_accent{1, 1, 1, 1};
    property::Color border{1, 1, 1, 0.13f};
    property::Color focus{0.565f, 0.757f, 1, 1};
    property::Color shade{0.02f, 0.027f, 0.043f, 0.6f};
    std::string font = "sans";
    double font_size = 17;
    double radius = 9;
    double padding = 22;
    double spacing = 10;
};

class Themes {
  public:
    using Element = Theme;
    void define(property::Tree& tree);
    /// Called after each change of a theme.
    void on_change(std::function<void()> changed) { changed_ = std::move(changed); }

    Theme& operator[](property::Row row) { return rows_[row]; }
    void changed(property::Row) {
        if (changed_) changed_();
    }
    const property::Class& of() const { return *class_; }
    /// The look of widgets without a theme.
    const Theme plain{};

  private:
    const property::Class* class_ = nullptr;
    module::Rows<Theme, std::deque> rows_;
    std::function<void()> changed_;
};

}  // namespace fettle::interface
