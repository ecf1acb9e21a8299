// Methods of World: queries, explosions.

#include <algorithm>
#include <stdexcept>
#include <string>

#include <fettle/property/acceptance.h>
#include <fettle/property/spelling.h>

#include <bindings/bindings.h>
#include <worlds/world_class.h>

namespace fettle::physics_module {
namespace {

using property::Field;
using property::Method;
using property::Record;
using property::Result;
using Arguments = std::span<const Value>;

const Field ray_from{"from", Type::vec2, "m", "Beginning of the ray."};
const Field ray_to{"to", Type::vec2, "m", "End of the ray."};
const Field mask{"mask", Type::integer, "",
                 "Categories to look for, as bits; all if it is left out."};

Field shape_field(std::string name, std::string doc) {
    return {.name = std::move(name),
            .type = Type::reference,
            .doc = std::move(doc),
            .reference_class = "Shape",
            .nullable = true};
}

const std::vector<Field> hit_fields = {
    shape_field("shape",
                "The shape that was hit; nil for the bounds of the world and the capsule of a "
                "mover."),
    {"body", Type::reference, "", "The body of the shape; the world itself for its bounds."},
    {"point", Type::vec2, "m", "Point of the hit in the world."},
    {"normal", Type::vec2, "",
     "Normal of the surface at the point, outward; its length is 1. If a shape that is cast "
     "overlaps the other one from the beginning: against the motion."},
    {"fraction", Type::number, "", "Distance along the ray, as a share from 0 to 1."},
};
const std::vector<Field> found_contact_fields = {
    {"body_a", Type::reference, "", "One of the two bodies.", "Body"},
    {"body_b", Type::reference, "", "The other body; the world itself for its bounds."},
    shape_field("shape_a", "The shape of body_a; nil for the capsule of a mover."),
    shape_field("shape_b", "The shape of body_b; nil for the bounds and the capsule of a mover."),
    {"point", Type::vec2, "m", "Point of the contact in the world."},
    {"normal", Type::vec2, "", "Direction from a to b; its length is 1."},
    {"separation", Type::number, "m",
     "Distance of the surfaces; below 0: the depth of their overlap."},
    {"force", Type::number, "N", "Force that separates them."},
};

const Field group{"group", Type::integer, "",
                  "Only shapes of this group are found if it is positive, and none of them if it "
                  "is negative."};
const std::vector<Field> near_fields = {
    shape_field("shape",
                "The nearest shape; nil for the bounds of the world and the capsule of a mover."),
    {"body", Type::reference, "", "Its body."},
    {"point", Type::vec2, "m",
     "The nearest point of its surface in the world; inside of the shape, the given point."},
    {"normal", Type::vec2, "",
     "Normal of the surface at the point, outward; the zero vector "
     "inside of the shape."},
    {"distance", Type::number, "m", "0 inside."},
};
const std::vector<Field> separation_fields = {
    {"distance", Type::number, "m", "Distance; 0 if they overlap."},
    {"point_a", Type::vec2, "m", "The point of the first that is nearest to the second."},
    {"point_b", Type::vec2, "m", "The point of the second that is nearest to the first."},
    {"normal", Type::vec2, "",
     "Direction from the first to the second; the zero vector if they "
     "overlap."},
};

const Field accept{
    "accept", Type::nil, "",
    "A function that gets a shape, a mover for its capsule, or nil for the bounds of the world, "
    "and returns whether it counts. It may read and search, but not change anything."};

/// The instance that a function `accept` gets: the capsule of a mover has none, but its body has.
Handle instance_with(const physics::Shape& shape) {
    const Handle instance = unpack(shape.user_data());
    return instance ? instance : unpack(shape.body().user_data());
}

physics::QueryFilter filter(const Value& categories, const Value& of_group = {},
                            const Value& function = {}) {
    physics::QueryFilter filter;
    if (!function.is_nil())
        filter.accept = [](const physics::Shape& shape) {
            return property::Acceptance::is_accepted(instance_with(shape));
        };
    if (!categories.is_nil()) filter.mask = from_value<std::uint64_t>(categories);
    if (!of_group.is_nil()) filter.group = static_cast<std::int32_t>(of_group.integer());
    return filter;
}

class Instances {
  public:
    explicit Instances(HostedWorld& hosted) : hosted_(hosted) {}
    Handle of(const physics::Shape& shape) const { return unpack(shape.user_data()); }
    Handle of(const physics::Body& body) const {
        const Handle handle = unpack(body.user_data());
        return handle ? handle : hosted_.self;
    }
    Handle of(physics::ShapeId id) const { return of(hosted_.world.shape(id)); }
    Handle of(physics::BodyId id) const { return of(hosted_.world.body(id)); }

  private:
    HostedWorld& hosted_;
};

Record hit_record(const Instances& instances, const physics::RayHit& hit) {
    return {&hit_fields,
            {instances.of(hit.shape), instances.of(hit.shape.body()), to_value(hit.point),
             to_value(hit.normal), to_value(hit.fraction)}};
}

Result raycast(HostedWorld& hosted, Arguments a) {
    const auto hit =
        hosted.world.cast_ray(vec2_argument(a[0]), vec2_argument(a[1]), filter(a[2], a[3], a[4]));
    if (!hit) return Value();
    return hit_record(Instances(hosted), *hit);
}

Result raycast_all(HostedWorld& hosted, Arguments a) {
    std::vector<Record> records;
    for (const physics::RayHit& hit : hosted.world.cast_ray_all(
             vec2_argument(a[0]), vec2_argument(a[1]), filter(a[2], a[3], a[4])))
        records.push_back(hit_record(Instances(hosted), hit));
    return records;
}

/// Returns the body with the smallest shape at the point, because a small shape in front of a large
/// one is probably meant. Sensors count, so that they can be selected, too.
Result at(HostedWorld& hosted, Arguments a) {
    physics::QueryFilter all = filter(a[1], a[2], a[3]);
    all.sensors = true;
    const auto found = hosted.world.query_point(vec2_argument(a[0]), all);
    const auto smallest = std::min_element(
        found.begin(), found.end(),
        [](const physics::Shape& x, const physics::Shape& y) { return x.area() < y.area(); });
    return found.empty() ? Value() : Value(Instances(hosted).of(smallest->body()));
}

/// The bodies of the shapes, each once.
Value bodies_of(const Instances& instances, const std::vector<physics::Shape>& shapes) {
    property::List bodies;
    for (const physics::Shape& shape : shapes) {
        const Value body(instances.of(shape.body()));
        if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) bodies.push_back(body);
    }
    return Value(std::move(bodies));
}

Result overlap_box(HostedWorld& hosted, Arguments a) {
    const physics::Vec2 p = vec2_argument(a[0]), q = vec2_argument(a[1]);
    physics::QueryFilter all = filter(a[2], a[3], a[4]);
    all.sensors = true;
    return bodies_of(Instances(hosted), hosted.world.query_aabb({p.min(q), p.max(q)}, all));
}

/// The shapes for a reference to a shape or to a body.
std::vector<physics::Shape> shapes_of(Hosting& hosting, const Value& value, const char* what) {
    const Handle instance = value.reference();
    const property::Class& is = hosting.tree.class_of(instance);
    const Row row = hosting.tree.row(instance);
    if (is.is_a(*hosting.classes.shape)) return {hosting.shape(row)};
    if (is.is_a(*hosting.classes.body)) return hosting.body(row).shapes();
    throw std::invalid_argument(std::string(what) + ": expected a shape or a body, got " +
                                property::with_article(is.name()));
}

Result overlap(Hosting& hosting, HostedWorld& hosted, Arguments a) {
    std::vector<physics::Shape> found;
    physics::QueryFilter seen = filter(a[1], a[2], a[3]);
    seen.sensors = true;
    for (const physics::Shape& shape : shapes_of(hosting, a[0], "shape")) {
        const auto some = hosted.world.query_overlap(shape, seen);
        found.insert(found.end(), some.begin(), some.end());
    }
    return bodies_of(Instances(hosted), found);
}

Result shapecast(Hosting& hosting, HostedWorld& hosted, Arguments a) {
    std::optional<physics::RayHit> first;
    for (const physics::Shape& shape : shapes_of(hosting, a[0], "shape")) {
        const auto hit =
            hosted.world.cast_shape(shape, vec2_argument(a[1]), filter(a[2], a[3], a[4]));
        if (hit && (!first || hit->fraction < first->fraction)) first = hit;
    }
    if (!first) return Value();
    return hit_record(Instances(hosted), *first);
}

Result closest(Hosting&, HostedWorld& hosted, Arguments a) {
    const float reach = a[1].is_nil() ? physics::infinity : static_cast<float>(a[1].number());
    const auto hit = hosted.world.closest(vec2_argument(a[0]), reach, filter(a[2], a[3], a[4]));
    if (!hit) return Value();
    const Instances instances(hosted);
    return Record{&near_fields,
                  {instances.of(hit->shape), instances.of(hit->shape.body()), to_value(hit->point),
                   to_value(hit->normal), to_value(hit->distance)}};
}

Result distance(Hosting& hosting, HostedWorld&, Arguments a) {
    std::optional<physics::Separation> nearest;
    for (const physics::Shape& one : shapes_of(hosting, a[0], "a")) {
        for (const physics::Shape& other : shapes_of(hosting, a[1], "b")) {
            const physics::Separation gap = physics::distance(one, other);
            if (!nearest || gap.distance < nearest->distance) nearest = gap;
        }
    }
    if (!nearest) return Value();
    return Record{&separation_fields,
                  {to_value(nearest->distance), to_value(nearest->point_a),
                   to_value(nearest->point_b), to_value(nearest->normal)}};
}

/// The arguments of an explosion after its point, which are numbers. Their errors name them.
float number_argument(Arguments a, std::size_t index, const char* name) {
    try {
        return float_argument(a[index]);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(std::string(name) + ": " + error.what());
    }
}

Result explode(Hosting&, HostedWorld& hosted, Arguments a) {
    hosted.world.explode(vec2_argument(a[0]), number_argument(a, 1, "radius"),
                         number_argument(a, 2, "impulse"), filter(a[3], Value(), a[4]));
    return Value();
}

Result explode_surfaces(Hosting&, HostedWorld& hosted, Arguments a) {
    hosted.world.explode({.point = vec2_argument(a[0]),
                          .radius = number_argument(a, 1, "radius"),
                          .falloff = number_argument(a, 2, "falloff"),
                          .impulse_per_length = number_argument(a, 3, "impulse_per_length")},
                         filter(a[4], Value(), a[5]));
    return Value();
}

Result contacts_of_world(HostedWorld& hosted, Arguments) {
    const Instances instances(hosted);
    std::vector<Record> records;
    for (const physics::Contact& contact : hosted.world.contacts()) {
        // In the library the border is side a; here it is side b, so that a is a body.
        const bool swap = contact.body_a.index == 0;
        const auto body_a = swap ? contact.body_b : contact.body_a;
        const auto body_b = swap ? contact.body_a : contact.body_b;
        const auto shape_a = swap ? contact.shape_b : contact.shape_a;
        const auto shape_b = swap ? contact.shape_a : contact.shape_b;
        const physics::Vec2 normal = swap ? physics::Vec2(-contact.normal) : contact.normal;
        float impulses = 0.0f;
        for (int k = 0; k < contact.point_count; ++k)
            impulses += contact.points[static_cast<std::size_t>(k)].normal_impulse;
        for (int k = 0; k < contact.point_count; ++k) {
            const physics::ContactPoint& p = contact.points[static_cast<std::size_t>(k)];
            const float share = impulses > 0.0f ? p.normal_impulse / impulses : 0.0f;
            records.push_back({&found_contact_fields,
                               {instances.of(body_a), instances.of(body_b), instances.of(shape_a),
                                instances.of(shape_b), to_value(p.point), to_value(normal),
                                to_value(p.separation), to_value(share * contact.normal_force)}});
        }
    }
    return records;
}

template <Result (*Run)(HostedWorld&, Arguments)>
Method method(Hosting& hosting, Method described) {
    described.context = &hosting;
    described.effect = property::Effect::nothing;
    described.call = [](void* context, property::Tree&, Handle, Row row, Arguments arguments) {
        return Run(static_cast<Hosting*>(context)->hosted(row), arguments);
    };
    return described;
}

template <Result (*Run)(Hosting&, HostedWorld&, Arguments)>
Method method(Hosting& hosting, Method described) {
    described.context = &hosting;
    described.call = [](void* context, property::Tree&, Handle, Row row, Arguments arguments) {
        Hosting& h = *static_cast<Hosting*>(context);
        return Run(h, h.hosted(row), arguments);
    };
    return described;
}

}  // namespace

std::vector<Method> world_methods(Hosting& hosting) {
    const Field probe{"shape", Type::reference, "", "A shape or a body, of any world or of none."};
    const Field bodies{.name = "bodies",
                       .type = Type::list,
                       .doc = "Each body once, in any order.",
                       .reference_class = "Body",
                       .element = Type::reference};
    const Field corner{"corner", Type::vec2, "m", "A corner of the box."};
    const Field opposite{"opposite", Type::vec2, "m", "The opposite corner."};
    return {
        method<raycast>(hosting,
                        {.name = "raycast",
                         .parameters = {ray_from, ray_to, mask, group, accept},
                         .required = 2,
                         .returns = hit_fields,
                         .doc = "The first shape that a ray hits, or nil. Sensors and shapes in "
                                "which the ray begins do not count."}),
        method<raycast_all>(hosting,
                            {.name = "raycast_all",
                             .parameters = {ray_from, ray_to, mask, group, accept},
                             .required = 2,
                             .returns = hit_fields,
                             .many = true,
                             .doc = "Every shape that a ray hits, the nearest first. Sensors and "
                                    "shapes in which the ray begins do not count."}),
        method<at>(hosting,
                   {.name = "at",
                    .parameters =
                        {{"point", Type::vec2, "m", "A point in the world."}, mask, group, accept},
                    .required = 1,
                    .returns = {{.name = "body",
                                 .type = Type::reference,
                                 .doc = "The body, or nil.",
                                 .reference_class = "Body",
                                 .nullable = true}},
                    .doc = "The body at a point, or nil. If there are several, the one with the "
                           "smallest shape. Sensors count, too."}),
        method<overlap_box>(hosting, {.name = "overlap_box",
                                      .parameters = {corner, opposite, mask, group, accept},
                                      .required = 2,
                                      .returns = {bodies},
                                      .doc = "The bodies that overlap a box. Sensors count, too."}),
        method<overlap>(hosting,
                        {.name = "overlap",
                         .parameters = {probe, mask, group, accept},
                         .required = 1,
                         .returns = {bodies},
                         .doc = "The bodies that overlap a shape or a body; not its own body. A "
                                "shape without a body is at its own coordinates.",
                         .effect = property::Effect::nothing}),
        method<shapecast>(
            hosting,
            {.name = "shapecast",
             .parameters = {probe,
                            {"motion", Type::vec2, "m", "Distance and direction of the motion."},
                            mask,
                            group,
                            accept},
             .required = 2,
             .returns = hit_fields,
             .doc = "The first shape that a moving shape or body would hit, or nil. Sensors do "
                    "not count.",
             .effect = property::Effect::nothing}),
        method<closest>(
            hosting, {.name = "closest",
                      .parameters = {{"point", Type::vec2, "m", "A point in the world."},
                                     {"reach", Type::number, "m", "Largest distance."},
                                     mask,
                                     group,
                                     accept},
                      .required = 1,
                      .returns = near_fields,
                      .doc = "The shape nearest to a point, or nil. Sensors and the bounds do not "
                             "count.",
                      .effect = property::Effect::nothing}),
        method<distance>(hosting, {.name = "distance",
                                   .parameters = {{"a", Type::reference, "", "A shape or a body."},
                                                  {"b", Type::reference, "", "Another."}},
                                   .required = 2,
                                   .returns = separation_fields,
                                   .doc = "Distance between two shapes or bodies.",
                                   .effect = property::Effect::nothing}),
        method<explode>(
            hosting,
            {.name = "explode",
             .parameters = {{"point", Type::vec2, "m", "Center of the explosion in the world."},
                            {"radius", Type::number, "m", "Radius of the explosion."},
                            {"impulse", Type::number, "N s", "Impulse for a body at the point."},
                            mask,
                            accept},
             .required = 3,
             .doc = "Pushes bodies away from a point; the impulse decreases with the distance."}),
        method<explode_surfaces>(
            hosting,
            {.name = "explode_surfaces",
             .parameters = {{"point", Type::vec2, "m", "Center of the explosion in the world."},
                            {"radius", Type::number, "m", "Nearer shapes get the full impulse."},
                            {"falloff", Type::number, "m",
                             "The impulse decreases to 0 over this distance beyond the radius."},
                            {"impulse_per_length", Type::number, "N s",
                             "Impulse for each meter of a shape's outline as seen from the point."},
                            mask,
                            accept},
             .required = 4,
             .doc = "Pushes bodies away from a point, large ones more than small ones."}),
        method<contacts_of_world>(hosting, {.name = "contacts",
                                            .returns = found_contact_fields,
                                            .many = true,
                                            .doc = "Every point at which two bodies touch now."}),
    };
}

}  // namespace fettle::physics_module
