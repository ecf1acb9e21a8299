#pragma once
// Draws figures, text, pictures and the triangles of layers on a window or a picture in memory.
// Figures, text and small pictures go into batches of triangles with one texture.

#include <array>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include <fettle/app/surface.h>
#include <fettle/app/view.h>
#include <fettle/property/painter.h>

#include <draw/atlas.h>
#include <draw/batch.h>
#include <draw/canvas_vertex.h>
#include <draw/pictures.h>
#include <draw/quad_raster.h>
#include <draw/shade.h>
#include <outlines/area.h>
#include <outlines/border_rings.h>
#include <outlines/joined_figures.h>
#include <outlines/outline.h>
#include <outlines/visible_area.h>
#include <sfml/sfml.h>

namespace fettle::app {

class Canvas : public property::Painter, public Surface {
  public:
    explicit Canvas(sf::RenderTarget& target);

    void begin(property::Color background);
    void set_view(const View& view);
    /// Draws the batch.
    void flush();
    void release_textures() { textures_.clear(); }

    // Painter: world units, or pixels between begin_screen and end_screen.
    void clip(const property::Vec2& lower, const property::Vec2& upper) override;
    void gradient(const property::Gradient& gradient) override;
    property::Seen seen() const override {
        return {view_.center, view_.lower(), view_.upper(), view_.picture()};
    }
    double pixels_per_unit() const override { return pixels(1); }
    double label_scale() const override { return view_.label_scale; }
    void picture(const property::Picture& picture, const property::PictureArea& area,
                 const property::Vec2& lower, const property::Vec2& upper, property::Color tint,
                 bool smooth) override;
    void circle(const property::Vec2& center, double radius, const property::Paint& paint) override;
    void ellipse(const property::Vec2& center, const property::Vec2& radii, double angle,
                 const property::Paint& paint) override;
    void polygon(std::span<const property::Vec2> vertices, double rounding,
                 const property::Paint& paint) override;
    void line(const property::Vec2& from, const property::Vec2& to, property::Color color,
              float width) override;
    void point(const property::Vec2& position, property::Color color, float size) override;
    void text(const property::Vec2& position, std::string_view text, double height,
              property::Color color, property::TextAlign align) override;
    void part_of(std::uint64_t whole) override { whole_ = whole; }
    bool shows(property::Overlay overlay) const override { return view_.show.overlay(overlay); }
    bool sees(const property::Vec2& lower, const property::Vec2& upper) const override;
    void begin_screen() override;
    void end_screen() override;

    // Surface: pixels.
    float width() const override { return static_cast<float>(target_.getSize().x); }
    float height() const override { return static_cast<float>(target_.getSize().y); }
    Texture create_texture(unsigned width, unsigned height, const std::uint8_t* rgba) override;
    void update_texture(Texture texture, unsigned x, unsigned y, unsigned width, unsigned height,
                        const std::uint8_t* rgba) override;
    void destroy_texture(Texture texture) override;
    void triangles(std::span<const SurfaceVertex> vertices, std::span<const std::uint16_t> indices,
                   Texture texture, const ClipRectangle& clip) override;
    float text(float x, float y, std::string_view line, float size, SurfaceColor color,
               Face face) override;

  protected:
    void set_state(const State& state) override;
    void set_transform(const property::Transform& transform) override;

  private:
    struct Line;  // a line of text, ready to be drawn

    void draw(const std::vector<CanvasVertex>& vertices, sf::PrimitiveType type,
              const sf::Texture& texture, property::Blend blend);
    void draw_strip();
    bool draw_quads_here(const sf::Texture& texture, property::Blend blend, const PixelBox& clip);
    void set_clip(float left, float top, float right, float bottom);
    property::Paint faded(const property::Paint& paint) const;
    property::Color faded(property::Color color) const;
    void find_to_pixels() const;
    bool transformed() const { return !state().transform.is_identity(); }
    const property::Transform& to_pixels() const {
        if (!has_to_pixels_) find_to_pixels();
        return to_pixels_;
    }
    property::Vec2 exact(const property::Vec2& position) const { return to_pixels()(position); }
    sf::Vector2f pixel(const property::Vec2& position) const;
    double pixels(double length) const;
    bool outside(const property::Vec2& lower, const property::Vec2& upper) const;

    /// With a gradient, draws the fill through its texture and then the border. False if there is
    /// nothing to be done: the caller draws the figure.
    template <class Draw>
    bool in_gradient(const property::Paint& paint, const Draw& draw) {
        if (state().gradient == nullptr || shading_ || !(paint.fill.a > 0)) return false;
        draw_collected();
        if (shade_.full()) flush();  // the batch may refer to textures that `begin` frees
        shading_ = true;
        if (shade_.begin(*state().gradient, state().gradient_across)) {
            draw(property::Paint{paint.fill, {0, 0, 0, 0}, 0});
            draw_collected();
        }
        shade_.end();
        draw(property::Paint{{0, 0, 0, 0}, paint.border, paint.border_width});
        shading_ = false;
        return true;
    }
    // --- In figures.cpp
    /// Draws corners_, which must lie near the screen.
    void figure(float rounding, const property::Paint& paint);
    void large_figure(std::vector<property::Vec2> outline, const property::Paint& paint);
    VisibleArea visible_area(const property::Paint& paint) const;
    void draw_outline(const property::Paint& paint);  // of outline_, convex
    bool draw_sides(sf::Color fill);
    void draw_any_outline(const property::Paint& paint);
    void draw_disc(sf::Vector2f center, float radius, sf::Color color);
    void draw_rings(bool filled);
    void draw_inside(Area::Rule rule, sf::Color color);  // of the area in scratch_
    void draw_border(const BorderRings& rim, std::span<const Bend> bends, bool closed);

    // --- In parts.cpp
    bool is_collected(const property::Paint& paint);
    void collect();  // adds outline_ to collected_
    /// Draws the collected parts of one whole.
    void draw_collected();
    void draw_joined(const BorderRings& rim);
    void draw_parts();

    // --- In polylines.cpp
    /// Adds a line to the polyline of its whole. `width`: px, at least 1.
    void add_to_polyline(sf::Vector2f from, sf::Vector2f to, sf::Color color, float width);
    void draw_polyline();

    // --- In lettering.cpp
    bool lay_out(Line& line, float size, Face face);
    void draw_line_of_text(const Line& line, sf::Vector2f baseline, sf::Color color);

    CanvasVertex plain(sf::Vector2f position, sf::Color color) const;
    /// `texture`: null for figures without one, which are drawn with the white texels of any atlas.
    CanvasVertex* start_strip(std::size_t count, sf::Vector2f first,
                              const sf::Texture* texture = nullptr);
    /// Adds a part of a texture. The corners are top left, top right, bottom left, bottom right.
    void add_quad(const CanvasVertex (&corners)[4], const sf::Texture& texture);
    void begin_quads();
    void add_quad(sf::Vector2f lower, sf::Vector2f upper, const Patch& patch, sf::Color color);

    sf::RenderTarget& target_;
    Atlas atlas_{};
    View view_{};
    Pictures pictures_{};
    QuadRaster raster_{};
    std::array<sf::Texture, 2> drawn_here_{};  // pictures of raster_, in turn
    std::size_t next_drawn_here_ = 0;
    Shade shade_{};
    bool shading_ = false;  // a figure with a gradient is being drawn
    property::Transform world_to_pixels_{}, screen_to_pixels_{};  // of view_
    // Of the coordinates that the state gives. Found when it is needed: most states that a `pop`
    // brings back draw nothing.
    mutable property::Transform to_pixels_{};
    mutable bool has_to_pixels_ = false;
    Batch batch_{};
    Outline outline_{};
    std::vector<sf::Vector2f> corners_{};
    /// The type of the straight sides of corners_. `touching`: no gap may show between this figure
    /// and its neighbors, such as tiles. `free`: the figure has its exact width, such as a line.
    enum class Edge : std::uint8_t { touching, free };
    Edge edge_ = Edge::free;  // type of corners_
    /// What the drawing of one figure needs. Kept for its memory.
    struct Scratch {
        std::vector<sf::Vector2f> rings{};  // of outline_, one after another, outermost first
        std::array<sf::Color, 4> ring_colors{};
        Area area{};
        std::vector<Trapezoid> trapezoids{};
    };
    Scratch scratch_{};
    std::uint64_t whole_ = 0;  // of the figures that are drawn now; 0: of none
    /// Parts of one whole with the same paint, to be drawn together.
    struct Collected {
        JoinedFigures parts{};
        std::uint64_t whole = 0;
        property::Paint paint{};
    };
    Collected collected_{};
    /// Lines of one whole, each of which begins where the one before it ends.
    struct Polyline {
        std::vector<sf::Vector2f> points{};
        sf::Color color{};
        float width = 0;  // px
        std::uint64_t whole = 0;
    };
    Polyline polyline_{};
    std::unordered_map<Texture, std::unique_ptr<sf::Texture>> textures_{};
    Texture next_texture_ = 1;
    std::vector<CanvasVertex> layer_{};
};

bool is_finite(const property::Vec2& v);

}  // namespace fettle::app
