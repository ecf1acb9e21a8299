#include <tilemaps/map_objects.h>

#include <cmath>
#include <numbers>

#include <fettle/property/spelling.h>

#include <tilemaps/grid.h>

namespace fettle::visuals {

using maps::Object;
using maps::ObjectKind;
using property::Class;
using property::Handle;
using property::List;
using property::Value;
using property::Vec2;

namespace {

Vec2 turned(const Vec2& p, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y};
}

class ObjectMaker {
  public:
    ObjectMaker(Maker& make, const LoadedMap& file, Handle parent, const MapPlace& place,
                bool smooth)
        : make_(make),
          tree_(make.tree()),
          file_(file),
          parent_(parent),
          place_(place),
          smooth_(smooth) {}

    void make(const Object& object) {
        make_.begin_messages("object " + std::to_string(object.id) +
                             (object.name.empty() ? "" : " \"" + object.name + "\""));
        const maps::Tile* const tile = object.tile.empty() ? nullptr : tile_of(object);
        const std::string kind =
            object.class_name.empty() && tile != nullptr ? tile->class_name : object.class_name;
        const Class& of = class_for(object, kind);
        const Handle made = make_.add(of, parent_, object.name);
        make_.remember(object.id, made);
        const bool plain = &of == &tree_.object_class();
        if (plain && !kind.empty()) make_.set_or_add(made, "kind", Value(kind));
        set_place(made, object, plain);
        if (tree_.class_of(made).is_a(tree_.class_named("Sprite")) && !object.tile.empty())
            show_tile(made, object);
        if (of.name() == "Body") add_shape(made, object);
        if (tile != nullptr) make_.set_custom(made, tile->properties);
        make_.set_custom(made, object.properties);
    }

  private:
    const maps::Tile* tile_of(const Object& object) const {
        return file_.map().tile(object.tile.gid);
    }

    /// The class of that name. Without one, a tile becomes a sprite and anything else an Object.
    const Class& class_for(const Object& object, const std::string& name) {
        const bool shows = name.empty() && object.kind == ObjectKind::tile;
        if (shows) return tree_.class_named("Sprite");
        if (name.empty()) return tree_.object_class();
        const Class* const found = tree_.find_class(name);
        // A map in a map could contain itself.
        if (found != nullptr && found->creatable() && !found->is_a(tree_.class_named("Tilemap")))
            return *found;
        std::vector<std::string> names;
        for (const Class* each : tree_.classes())
            if (each->creatable()) names.push_back(each->name());
        if (found != nullptr)
            make_.report("a map cannot make a " + name);
        else if (const std::string hint = property::suggestion(name, names); !hint.empty())
            make_.report("there is no class \"" + name + "\"" + hint);
        return tree_.object_class();
    }

    Vec2 size_of(const Object& object) const { return object.size / place_.pixels_per_unit; }

    /// The middle of the object from its position, in pixels, y down, before it is turned.
    Vec2 middle_of(const Object& object) const {
        const Vec2 half = 0.5 * object.size;
        if (object.kind == ObjectKind::rectangle || object.kind == ObjectKind::ellipse ||
            object.kind == ObjectKind::text)
            return half;
        if (object.kind != ObjectKind::tile) return {0, 0};
        const maps::Tileset* const set = file_.map().tileset_of(object.tile.gid);
        const std::string alignment = set == nullptr ? "" : set->alignment;
        Vec2 middle(half.x, -half.y);
        if (alignment.starts_with("top")) middle.y = half.y;
        if (alignment == "left" || alignment == "center" || alignment == "right") middle.y = 0;
        if (alignment == "top" || alignment == "center" || alignment == "bottom") middle.x = 0;
        if (alignment.ends_with("right")) middle.x = -half.x;
        return middle;
    }

    void set_place(Handle made, const Object& object, bool plain) {
        const double turn = object.rotation * std::numbers::pi / 180;
        const Vec2 middle = object.position + turned(middle_of(object), turn);
        const auto put = [&](const char* name, const Value& value) {
            if (plain)
                make_.set_or_add(made, name, value);
            else
                make_.set_if_there(made, name, value);
        };
        // Every object has a place, so the property is added if the class does not declare it.
        make_.set_or_add(made, "position", Value(place_.point(middle)));
        if (turn != 0) put("angle", Value(-turn));
        if (object.size.x > 0 || object.size.y > 0) {
            const property::Property* const size = tree_.find(made, "size");
            if (plain || (size != nullptr && size->type == property::Type::vec2))
                put("size", Value(size_of(object)));
            make_.set_if_there(made, "width", Value(size_of(object).x));
            make_.set_if_there(made, "height", Value(size_of(object).y));
        }
        if (!object.points.empty()) put("points", points_of(object));
        if (object.kind == ObjectKind::text) put("text", Value(object.text));
        if (object.kind == ObjectKind::tile) {
            const auto number = static_cast<std::int64_t>(object.tile.gid);
            put("tile", Value(number));
        }
        if (!object.visible) make_.set_if_there(made, "visible", Value(false));
    }

    Value points_of(const Object& object) const {
        List points;
        for (const Vec2& p : object.points) points.emplace_back(place_.length(p));
        return Value(std::move(points));
    }

    /// The picture of the tile, unless the class has one already.
    void show_tile(Handle made, const Object& object) {
        if (!tree_.get(made, "image").text().empty()) return;
        const maps::Tileset* const set = file_.map().tileset_of(object.tile.gid);
        if (set == nullptr)
            return make_.report("the map has no tile " + std::to_string(object.tile.gid));
        const maps::Tile* const tile = tile_of(object);
        if (tile != nullptr && !tile->image.empty()) {
            make_.set(made, "image", Value(tile->image));
        } else {
            make_.set(made, "image", Value(set->image));
            make_.set(made, "frame_size", Value(Vec2(set->tile_width, set->tile_height)));
            make_.set(made, "margin", Value(double(set->margin)));
            make_.set(made, "spacing", Value(double(set->spacing)));
            make_.set(made, "frame", Value(std::int64_t{object.tile.gid - set->first_gid} + 1));
        }
        make_.set(made, "flip_x", Value(object.tile.flip_x));
        make_.set(made, "flip_y", Value(object.tile.flip_y));
        make_.set(made, "smooth", Value(smooth_));
    }

    /// A body gets the shape that was drawn in the editor.
    void add_shape(Handle body, const Object& object) {
        const char* name = nullptr;
        const Vec2 size = size_of(object);
        if (object.kind == ObjectKind::polygon) name = "Concave";
        if (object.kind == ObjectKind::polyline) name = "Chain";
        if (size.x > 0 && size.y > 0) {
            if (object.kind == ObjectKind::rectangle || object.kind == ObjectKind::tile)
                name = "Box";
            if (object.kind == ObjectKind::ellipse) name = "Ellipse";
        }
        const Class* const of = name == nullptr ? nullptr : tree_.find_class(name);
        if (of == nullptr) return;
        const Handle shape = make_.add(*of, body, "shape");
        make_.set_if_there(shape, "width", Value(size.x));
        make_.set_if_there(shape, "height", Value(size.y));
        make_.set_if_there(shape, "radius_x", Value(0.5 * size.x));
        make_.set_if_there(shape, "radius_y", Value(0.5 * size.y));
        if (object.points.empty()) return;
        make_.set_if_there(shape, "vertices", points_of(object));
        make_.set_if_there(shape, "points", points_of(object));
    }

    Maker& make_;
    property::Tree& tree_;
    const LoadedMap& file_;
    Handle parent_;
    MapPlace place_;
    bool smooth_;
};

}  // namespace

void make_objects(Maker& make, const LoadedMap& file, const maps::Layer& layer, Handle parent,
                  const MapPlace& place, bool smooth) {
    ObjectMaker maker(make, file, parent, place, smooth);
    for (const Object& object : layer.objects) maker.make(object);
}

}  // namespace fettle::visuals
