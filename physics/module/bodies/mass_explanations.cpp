// How the shapes of a body determine its mass, center and inertia.

#include <bodies/mass_explanations.h>

#include <cmath>

#include <fettle/property/explaining.h>

#include <bindings/bindings.h>
#include <bodies/motion_account.h>

namespace fettle::physics_module {
namespace {

using Lines = std::vector<std::string>;

struct Weighed {
    Hosting& hosting;
    physics::Body body;

    std::string text(const Value& value) const {
        return hosting.tree.text(value, property::Precision::single_precision);
    }
    std::string path(const physics::Shape& shape) const {
        const Handle instance = hosting.instance_of(shape.user_data());
        return instance ? hosting.tree.path(instance) : "a shape";
    }
    physics::Vec2 centroid(const physics::Shape& shape) const {
        return body.local_point(shape.world_center());
    }
    float distance(const physics::Shape& shape) const {
        return (centroid(shape) - body.center()).length();
    }
    /// Inertia of a shape about its own center of mass, kg m².
    static float inertia(const physics::Shape& shape) {
        physics::World world;
        physics::Body alone = world.create_body();
        alone.add(shape.geometry(), {.density = shape.density()});
        return shape.mass() > 0 ? alone.inertia() : 0;
    }

    Lines mass() const {
        if (body.mass_override()) return {"it was set; nil computes it from the shapes"};
        Lines lines;
        for (const physics::Shape& shape : body.shapes())
            lines.push_back(path(shape) + ": " + text(to_value(shape.mass())) + " kg = density " +
                            text(to_value(shape.density())) + " kg/m² × area " +
                            text(to_value(shape.area())) + " m²");
        if (!(total() > 0)) lines.push_back("a dynamic body whose shapes have no mass has 1 kg");
        return lines;
    }
    float total() const {
        float sum = 0;
        for (const physics::Shape& shape : body.shapes()) sum += shape.mass();
        return sum;
    }
    Lines center() const {
        if (body.center_override()) return {"it was set; nil computes it from the shapes"};
        if (body.type() == physics::BodyType::kinematic_body)
            return {"a kinematic body turns about its position"};
        if (!(total() > 0)) return {"without a mass of shapes it is the origin of the body"};
        Lines lines;
        for (const physics::Shape& shape : body.shapes())
            lines.push_back(path(shape) + ": " + text(to_value(centroid(shape))) + " m, with " +
                            text(to_value(shape.mass() / total())) + " of the mass");
        return lines;
    }
    Lines inertia() const {
        if (body.inertia_override()) return {"it was set; nil computes it from the shapes"};
        if (!(total() > 0)) return {"without a mass of shapes the body does not turn"};
        Lines lines;
        for (const physics::Shape& shape : body.shapes()) {
            const float own = inertia(shape), away = distance(shape);
            lines.push_back(path(shape) + ": " + text(to_value(own + shape.mass() * away * away)) +
                            " kg m² = " + text(to_value(own)) + " kg m² + " +
                            text(to_value(shape.mass())) + " kg × (" + text(to_value(away)) +
                            " m)²");
        }
        if (body.mass_override() && std::isfinite(body.mass()))
            lines.push_back("times " + text(to_value(body.mass() / total())) +
                            ", because the mass was set");
        return lines;
    }
};

using Explain = Lines (Weighed::*)() const;

property::Explainer weighed(Hosting& hosting, Explain explain) {
    return {.sources = [&hosting, explain](Handle self) {
        return (Weighed{hosting, hosting.body(hosting.tree.row(self))}.*explain)();
    }};
}

}  // namespace

void explain_bodies(Hosting& hosting, const property::Class& body) {
    property::Tree& tree = hosting.tree;
    property::explain_with(tree, *body.property("mass"), weighed(hosting, &Weighed::mass));
    property::explain_with(tree, *body.property("center"), weighed(hosting, &Weighed::center));
    property::explain_with(tree, *body.property("inertia"), weighed(hosting, &Weighed::inertia));
    explain_motion(hosting, body);
}

}  // namespace fettle::physics_module
