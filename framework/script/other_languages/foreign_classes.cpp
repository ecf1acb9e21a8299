// Unity, Godot, Box2D, Chipmunk, Roblox and libraries of JavaScript.

#include <algorithm>
#include <iterator>
#include <string>

#include <fettle/property/error.h>

#include <other_languages/foreign_classes.h>
#include <text/words.h>

namespace fettle::script {

namespace {

struct ForeignClass {
    std::string_view words;  // as class_word() makes them, separated by blanks
    std::string_view here;   // a class, or what is written in its place
};

constexpr ForeignClass foreign_classes[] = {
    {"rigidbody rigidbodydef staticbody animatablebody bodydef", "Body"},
    {"charactercontroller characterbody kinematicbody charactermover", "Mover"},
    {"area", "Circle { sensor = true } in a body"},
    {"collider collisionshape fixture fixturedef", "Circle { ... } or Box { ... } in a body"},
    {"circle circlecollider circleshape circledef spherecollider sphere", "Circle"},
    {"box boxcollider boxshape rectangleshape rectangle rect cuboid quad aabb", "Box"},
    {"capsule capsulecollider capsuleshape", "Capsule"},
    {"polygon polygoncollider polygonshape collisionpolygon convexpolygonshape convexpolygon poly "
     "polyshape",
     "Polygon"},
    {"concavepolygonshape meshcollider", "Concave"},
    {"segment edgeshape edge segmentshape", "Segment"},
    {"edgecollider chain chainshape chaindef polyline", "Chain"},
    {"revolutejoint hingejoint hinge pinjoint pivotjoint pivot hingeconstraint revolute "
     "revolutejointdef",
     "RevoluteJoint"},
    {"prismaticjoint sliderjoint prismatic sliderconstraint prismaticjointdef", "PrismaticJoint"},
    {"distancejoint springjoint dampedspring dampedspringjoint spring rope ropejoint slidejoint "
     "distanceconstraint springconstraint rodconstraint ropeconstraint distancejointdef",
     "DistanceJoint"},
    {"weldjoint fixedjoint weldconstraint weld fixedconstraint weldjointdef", "WeldJoint"},
    {"mousejoint targetjoint mouseconstraint dragjoint mousejointdef", "MouseJoint"},
    {"motorjoint frictionjoint relativejoint simplemotor", "MotorJoint"},
    {"wheeljoint suspensionjoint wheelcollider wheelconstraint wheeljointdef", "WheelJoint"},
    {"rotarylimit", "RotaryLimitJoint"},
    {"ratchet ratchetjoint", "RatchetJoint"},
    {"gear gearjoint", "GearJoint"},
    {"pulley pulleyjoint", "PulleyJoint"},
    {"areaeffector", "Field"},
    {"pointeffector", "Attractor"},
    {"buoyancyeffector", "Buoyancy"},
    {"sprite spriterenderer animatedsprite animatedtexture texturerect", "Sprite"},
    {"line linerenderer", "Line"},
    {"textmesh textmeshpro richtextlabel", "Text"},
    {"particlesystem particles gpuparticles cpuparticles particleemitter", "Emitter"},
    {"camera", "Camera"},
    {"tilemap tilemaplayer", "Tilemap"},
    {"audiosource audiostreamplayer soundplayer", "Sound"},
    {"audiolistener", "audio"},
    {"lineedit textedit inputfield", "TextField"},
    {"checkbox checkbutton", "Toggle"},
    {"hslider vslider", "Slider"},
    {"texturebutton", "Button"},
    {"hboxcontainer hbox", "Row"},
    {"vboxcontainer vbox", "Column"},
    {"panelcontainer canvaslayer", "Panel"},
    {"node gameobject", "Object"},
    {"timer", "after(seconds, action)"},
};

/// "b2HingeJoint2D", "hinge_joint" and "HingeJoint" are one word.
std::string class_word(std::string_view name) {
    for (const std::string_view prefix : {"b2", "cp"})
        if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
    for (const std::string_view suffix : {"2D", "2d", "3D"})
        if (name.ends_with(suffix)) name.remove_suffix(suffix.size());
    std::string text = lower(name);
    std::erase(text, '_');
    return text;
}

/// A class begins with a capital letter, or has the prefix of a library: `rope` and `spring` are
/// names of variables.
bool may_be_class(std::string_view name) {
    return (!name.empty() && name[0] >= 'A' && name[0] <= 'Z') || name.starts_with("b2") ||
           name.starts_with("cp");
}

}  // namespace

std::string hint_for_class(std::string_view name) {
    if (!may_be_class(name)) return {};
    const std::string word = class_word(name);
    const auto* const found = std::ranges::find_if(
        foreign_classes, [&](const ForeignClass& each) { return holds_word(each.words, word); });
    if (found == std::end(foreign_classes)) return {};
    const bool is_class = found->here.find_first_of(" (") == std::string_view::npos &&
                          found->here[0] >= 'A' && found->here[0] <= 'Z';
    return " (write " + std::string(found->here) + (is_class ? " { ... })" : ")");
}

const property::Class& class_called(const property::Tree& tree, std::string_view name) {
    if (tree.find_class(name) == nullptr)
        if (const std::string hint = hint_for_class(name); !hint.empty())
            throw property::Error(property::ErrorKind::unknown_name,
                                  "no class is called \"" + std::string(name) + "\"" + hint);
    return tree.class_named(name);
}

}  // namespace fettle::script
