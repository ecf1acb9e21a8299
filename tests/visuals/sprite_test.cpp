// Sprites: where they are drawn, their images, their frames.

#include <catch.h>

#include <fettle/property/between_steps.h>
#include <fettle/property/storage/saves.h>

#include "gallery.h"

namespace sprite_test {

using namespace fettle::visuals::test;

namespace {

/// 2 x 4 m: 8 x 4 pixels, 4 in a meter.
const std::vector<std::pair<std::string, Value>> hero{{"image", "hero.tga"},
                                                      {"pixels_per_unit", 4.0}};

/// An export with frames of 4 x 4 pixels and the tags "walk" (2 and 3) and "back".
std::string exported() {
    const auto frame = [](int x) {
        return R"({"frame":{"x":)" + std::to_string(x) +
               R"(,"y":1,"w":2,"h":2},"spriteSourceSize":{"x":1,"y":1,"w":2,"h":2},)"
               R"("sourceSize":{"w":4,"h":4},"duration":100})";
    };
    return R"({"frames":[)" + frame(0) + "," + frame(2) + "," + frame(4) + R"(],"meta":{)" +
           R"("image":"hero.tga","frameTags":[{"name":"walk","from":1,"to":2},)" +
           R"({"name":"back","from":0,"to":2,"direction":"reverse"}]}})";
}

}  // namespace

TEST_CASE_METHOD(Gallery, "sprites and lines are drawn between two steps") {
    const Handle above = make("Sprite", {{"image", "hero.tga"}, {"pixels_per_unit", 4.0}});
    const Handle below = make("Sprite", {{"image", "hero.tga"}, {"pixels_per_unit", 4.0}}, above);
    const Handle line = make("Line", {{"points", List{Vec2(0, 0), Vec2(1, 0)}}, {"width", 0.01}});
    const auto left = [&](std::size_t n) { return draw({}, 0.5).at(n).lower_left; };
    const Vec2 from_above = left(0), from_below = left(1), from_line = left(2);
    note_step_begins(tree);
    tree.set(above, "position", Value(Vec2(1, 0)));
    tree.set(below, "position", Value(Vec2(0, 1)));
    tree.set(line, "position", Value(Vec2(0, 1)));
    tree.set(line, "points", Value(List{Vec2(0, 1), Vec2(1, 0)}));
    note_step_ended(tree, {.world = 2, .screen = 100});
    CHECK(near(left(0), from_above + Vec2(0.5, 0)));
    CHECK(near(left(1), from_below + Vec2(0.5, 0.5)));
    CHECK(near(left(2), from_line + Vec2(0, 1)));
    CHECK(near(draw({}, 1).at(0).lower_left, from_above + Vec2(1, 0)));
}

TEST_CASE_METHOD(Gallery, "the picture of a saved game is an image") {
    std::uint32_t wide = 2;
    visuals.saved_pictures([&](const std::string& slot) {
        if (slot != "quick") return Thumbnail{};
        return Thumbnail{wide, 1, std::vector<std::uint8_t>(std::size_t{4} * wide, 255)};
    });
    const Handle s = make("Sprite", {{"image", "save:quick"}});
    CHECK(tree.get(s, "image_width") == Value(2));
    REQUIRE(draw().size() == 1);
    CHECK(draw()[0].picture->rgba()[3] == 255);
    wide = 3;  // it was saved again
    visuals.renew("save:quick");
    CHECK(tree.get(s, "image_width") == Value(3));
    tree.set(s, "image", Value("save:none"));  // nothing is drawn and nothing is reported
    CHECK(draw()[0].picture->rgba()[3] == 0);
    CHECK(problems.empty());
}

TEST_CASE_METHOD(Gallery, "a sprite is drawn around its origin") {
    const Handle s = make("Sprite", hero);
    auto drawn = draw();
    REQUIRE(drawn.size() == 1);
    CHECK(near(drawn[0].lower_left, {-1, -0.5}));
    CHECK(near(drawn[0].lower_right, {1, -0.5}));
    CHECK(near(drawn[0].upper_left, {-1, 0.5}));
    CHECK(drawn[0].area.width == 8);
    CHECK(drawn[0].picture->width() == 8);
    CHECK(drawn[0].picture->rgba()[0] == 0);  // red of the top left pixel
    CHECK(drawn[0].picture->rgba()[2] == 10);
    tree.set(s, "origin", Value(Vec2(0, 0)));
    tree.set(s, "position", Value(Vec2(3, 4)));
    tree.set(s, "angle", Value(std::acos(0.0)));
    tree.set(s, "scale", Value(2.0));
    drawn = draw();
    CHECK(near(drawn[0].lower_left, {3, 4}));
    CHECK(near(drawn[0].lower_right, {3, 8}));
    CHECK(near(drawn[0].upper_left, {1, 4}));
    tree.set(s, "size", Value(Vec2(1, 1)));
    CHECK(near(draw()[0].lower_right, {3, 6}));
    tree.set(s, "size", Value());
    CHECK(near(draw()[0].lower_right, {3, 8}));
    tree.set(s, "visible", Value(false));
    CHECK(draw().empty());
}

TEST_CASE_METHOD(Gallery, "a sprite is mirrored about its origin") {
    const Handle s = make("Sprite", hero);
    tree.set(s, "origin", Value(Vec2(0.25, 0)));
    tree.set(s, "flip_x", Value(true));
    tree.set(s, "flip_y", Value(true));
    const auto drawn = draw();
    CHECK(near(drawn[0].lower_left, {0.5, 0}));
    CHECK(near(drawn[0].lower_right, {-1.5, 0}));
    CHECK(near(drawn[0].upper_left, {0.5, -1}));
}

TEST_CASE_METHOD(Gallery, "tint and blend and filter reach the painter") {
    const Handle s = make("Sprite", hero);
    tree.set(s, "tint", Value(Color{1, 0, 0, 0.5f}));
    tree.set(s, "blend", Value("add"));
    tree.set(s, "smooth", Value(false));
    const auto drawn = draw();
    CHECK(drawn[0].color == Color{1, 0, 0, 0.5f});
    CHECK(drawn[0].blend == Blend::add);
    CHECK_FALSE(drawn[0].smooth);
}

TEST_CASE_METHOD(Gallery, "a sprite follows the instance above it") {
    const Handle ship = make("Object");
    tree.set_or_add(ship, "position", Value(Vec2(10, 0)));
    tree.set_or_add(ship, "angle", Value(std::acos(0.0)));
    const Handle outer = make("Sprite", {{"position", Value(Vec2(2, 0))}, {"scale", 3.0}}, ship);
    const Handle inner = make("Sprite", hero, outer);
    tree.set(inner, "position", Value(Vec2(1, 0)));
    tree.set(inner, "origin", Value(Vec2(0, 0)));
    const auto drawn = draw();
    REQUIRE(drawn.size() == 1);  // the outer one has no image
    CHECK(near(drawn[0].lower_left, {10, 5}));
    CHECK(near(drawn[0].lower_right, {10, 11}));
    // A class may say where its instances are drawn in this picture.
    ClassDescriptor moving{.name = "Moving"};
    moving.lifecycle.pose = [](void*, const Tree&, Handle, Row, double alpha) {
        return Transform::placed({alpha, 1}, 0);
    };
    tree.move(inner, tree.create(tree.define(moving), tree.root()));
    CHECK(near(draw({}, 0.25)[0].lower_left, {1.25, 1}));
}

TEST_CASE_METHOD(Gallery, "an image is loaded once and shared") {
    make("Sprite", hero);
    make("Sprite", hero);
    const auto drawn = draw();
    CHECK(drawn[0].picture == drawn[1].picture);
}

TEST_CASE_METHOD(Gallery, "a missing image is a checkerboard and one error") {
    const Handle s = make("Sprite", {{"image", "hreo.tga"}});
    make("Sprite", {{"image", "hreo.tga"}});
    step(3);
    draw();
    CHECK(problems == std::vector<std::string>{
                          tree.path(s) + ".image: there is no file \"hreo.tga\" (did you mean "
                                         "\"hero.tga\"?)"});
    CHECK(tree.get(s, "image_width") == Value(32));
    CHECK(draw().size() == 2);
    write("broken.png", "this is not an image");
    tree.set(s, "image", Value("broken.png"));
    step(1);
    REQUIRE(problems.size() == 2);
    CHECK_THAT(problems[1],
               contains(tree.path(s) + ".image: \"broken.png\": cannot be read as PNG"));
    tree.set(s, "image", Value("../hero.tga"));
    step(1);
    REQUIRE(problems.size() == 3);
    CHECK_THAT(problems[2], contains("is not a file below the game's folder"));
    tree.set(s, "image", Value("hero.tga"));
    CHECK(tree.get(s, "image_width") == Value(8));
    CHECK(tree.get(s, "image_height") == Value(4));
}

TEST_CASE_METHOD(Gallery, "frames may have a distance from each other and from the edge") {
    write("sheet.tga", tga(30, 22));  // 3 x 2 frames of 8 pixels, and some pixels more
    const Handle s = make("Sprite", {{"image", "sheet.tga"},
                                     {"frame_size", Vec2(8, 8)},
                                     {"spacing", 1.0},
                                     {"margin", 2.0},
                                     {"frame", 6}});
    const auto area = [&] {
        const PictureArea drawn = draw().at(0).area;
        return std::vector{drawn.left, drawn.top, drawn.width, drawn.height};
    };
    CHECK(tree.get(s, "frame_count") == Value(6));
    CHECK(area() == std::vector<double>{20, 11, 8, 8});
    tree.set(s, "frame", Value(2));
    CHECK(area() == std::vector<double>{11, 2, 8, 8});
    tree.set(s, "frame_size", Value());
    tree.set(s, "sheet", Value(List{Value(5), Value(1)}));
    CHECK(area() == std::vector<double>{2 + 5.4, 2, 4.4, 18});
    tree.set(s, "frame_size", Value(Vec2(1000, 1000)));  // at least one frame
    CHECK(tree.get(s, "frame_count") == Value(1));
}

TEST_CASE_METHOD(Gallery, "columns and rows can be set as one value") {
    const Handle s = make("Sprite", hero);
    tree.set(s, "sheet", Value(List{Value(4), Value(2)}));
    CHECK(tree.get(s, "columns") == Value(4));
    CHECK(tree.get(s, "rows") == Value(2));
    tree.set(s, "frame", Value(6));
    CHECK(draw()[0].area.left == 2);
    CHECK(draw()[0].area.top == 2);
    tree.set(s, "columns", Value(8));
    CHECK(tree.get(s, "sheet") == Value(List{Value(8), Value(2)}));
    CHECK_THROWS_AS(tree.set(s, "sheet", Value(List{Value(4)})), fettle::property::Error);
    CHECK_THROWS_AS(tree.set(s, "sheet", Value(List{Value(4), Value(0)})), fettle::property::Error);
    CHECK(tree.get(s, "columns") == Value(8));
}

TEST_CASE_METHOD(Gallery, "frames of a sheet go on with simulation time") {
    const Handle s = make("Sprite", hero);
    tree.set(s, "columns", Value(4));
    tree.set(s, "rows", Value(2));
    CHECK(tree.get(s, "frame_count") == Value(8));
    tree.set(s, "frame", Value(6));
    auto drawn = draw();
    CHECK(drawn[0].area.left == 2);
    CHECK(drawn[0].area.top == 2);
    CHECK(drawn[0].area.width == 2);
    CHECK(near(drawn[0].lower_right - drawn[0].lower_left, {0.5, 0}));
    step(10);
    CHECK(frame(s) == 6);  // no speed
    tree.set(s, "frames_per_second", Value(10.0));
    step(5);
    CHECK(frame(s) == 6);
    step(1);
    CHECK(frame(s) == 7);
    step(12);
    CHECK(frame(s) == 1);
    tree.set(s, "playing", Value(false));
    step(12);
    CHECK(frame(s) == 1);
    tree.set(s, "playing", Value(true));
    tree.set(s, "animation", Value("3-5"));
    CHECK(tree.get(s, "frame_count") == Value(3));
    CHECK(draw()[0].area.left == 4);
    step(18);
    CHECK(frame(s) == 1);
}

TEST_CASE_METHOD(Gallery, "an animation that does not loop finishes once") {
    const Handle s = make("Sprite", hero);
    int finished = 0;
    const auto on =
        tree.on(s, *tree.class_of(s).event("finished"), [&](const Occurrence&) { ++finished; });
    tree.set(s, "columns", Value(3));
    tree.set(s, "frames_per_second", Value(60.0));
    tree.set(s, "loop", Value(false));
    step(2);
    CHECK(frame(s) == 3);
    CHECK(finished == 0);
    step(5);
    CHECK(frame(s) == 3);
    CHECK(finished == 1);
    tree.set(s, "frame", Value(1));
    step(10);
    CHECK(finished == 2);
}

TEST_CASE_METHOD(Gallery, "snapshots contain the frame and its time") {
    const Handle s = make("Sprite", hero);
    tree.set(s, "columns", Value(8));
    tree.set(s, "frames_per_second", Value(10.0));
    step(15);
    const Snapshot before = tree.snapshot();
    step(20);
    const std::int64_t later = frame(s);
    tree.restore(before);
    CHECK(frame(s) == 3);
    step(20);
    CHECK(frame(s) == later);
    tree.destroy(s);
    tree.restore(Snapshot::from_bytes(before.to_bytes()));
    CHECK(frame(s) == 3);
    step(20);
    CHECK(frame(s) == later);
    CHECK(draw().size() == 1);
}

TEST_CASE_METHOD(Gallery, "the state hash is that of the sprites and not of their past") {
    std::vector<Handle> all;
    for (int i = 0; i < 4; ++i) {
        all.push_back(make("Sprite", hero));
        tree.set(all.back(), "columns", Value(8));
        tree.set(all.back(), "frames_per_second", Value(10.0 + i));
        step(5);
    }
    const Snapshot four = tree.snapshot();
    tree.destroy(all[0]);
    tree.destroy(all[3]);
    const Snapshot two = tree.snapshot();
    const std::uint64_t hash = visuals.hash();
    tree.restore(four);
    CHECK(visuals.hash() != hash);
    tree.restore(two);
    CHECK(visuals.hash() == hash);
    step(20);
    tree.restore(Snapshot::from_bytes(two.to_bytes()));
    CHECK(visuals.hash() == hash);
}

TEST_CASE_METHOD(Gallery, "a file of Aseprite has frames and animations and times") {
    write("hero.json", exported());
    const Handle s = make("Sprite", {{"image", "hero.json"}, {"pixels_per_unit", 1.0}});
    CHECK(tree.get(s, "frame_count") == Value(3));
    auto drawn = draw();
    CHECK(drawn[0].area.top == 1);
    CHECK(drawn[0].area.width == 2);
    CHECK(near(drawn[0].lower_left, {-1, -1}));  // the part in the middle of 4 x 4 pixels
    step(6);
    CHECK(frame(s) == 2);
    tree.set(s, "animation", Value("walk"));
    CHECK(tree.get(s, "frame_count") == Value(2));
    CHECK(draw()[0].area.left == 2);
    tree.set(s, "animation", Value("back"));
    CHECK(draw()[0].area.left == 4);
    CHECK(problems.empty());
    tree.set(s, "animation", Value("wlak"));
    step(2);
    CHECK(problems ==
          std::vector<std::string>{tree.path(s) +
                                   ".animation: hero.json has no animation \"wlak\" (did you mean "
                                   "\"walk\"?); it has 3 frames"});
}

TEST_CASE_METHOD(Gallery, "a hash export of Aseprite has its frames in the order of the file") {
    std::string frames;
    for (int n = 0; n < 12; ++n)
        frames += (n > 0 ? "," : "") + std::string("\"hero ") + std::to_string(n) +
                  R"(.aseprite":{"frame":{"x":)" + std::to_string(n) +
                  R"(,"y":0,"w":1,"h":1},"duration":100})";
    const std::string meta = R"("meta":{"image":"hero.tga","frameTags":[)"
                             R"({"name":"last","from":10,"to":11,"direction":"forward"}]})";
    write("hash.json", "{\"frames\":{" + frames + "}," + meta + "}");
    const Handle s = make("Sprite", {{"image", "hash.json"}});
    for (int n = 0; n < 12; ++n) {
        tree.set(s, "frame", Value(n + 1));
        CHECK(draw()[0].area.left == n);
    }
    tree.set(s, "animation", Value("last"));
    CHECK(draw()[0].area.left == 10);
    CHECK(problems.empty());
}

TEST_CASE_METHOD(Gallery,
                 "the pen draws a frame that a tool has cut at its place in the uncut frame") {
    write("hero.json", exported());
    const auto user = [] { return std::string("pen.image"); };
    const PictureFrame cut = visuals.media().frame(user, "hero.json", {.frame = 2});
    CHECK(cut.area.left == 2);
    CHECK(cut.offset == Vec2(1, 1));
    CHECK(cut.size == Vec2(4, 4));
    const PictureFrame part =
        visuals.media().frame(user, "hero.tga", {.columns = 4, .rows = 2, .frame = 6});
    CHECK(part.area.left == 2);
    CHECK(part.area.top == 2);
    CHECK(part.size == Vec2(2, 2));
}

TEST_CASE_METHOD(Gallery, "an export of Aseprite is read even if its image is loaded later") {
    std::string text = exported();
    text.replace(text.find("hero.tga"), 8, "late.tga");
    write("hero.json", text);
    const Handle s = make("Sprite", {{"image", "hero.json"}});
    CHECK(tree.get(s, "image_width") == Value(32));
    CHECK(problems.size() == 1);
    write("late.tga", tga(8, 4));
    visuals.renew("late.tga");
    CHECK(tree.get(s, "image_width") == Value(8));
    CHECK(tree.get(s, "frame_count") == Value(3));
}

TEST_CASE_METHOD(Gallery, "a broken file of Aseprite is an error") {
    const std::string whole = exported();
    write("a.json", whole.substr(0, whole.size() / 2));
    write("b.json", R"({"frames":[],"meta":{"image":"hero.tga"}})");
    write("c.json", R"({"frames":{"a":7},"meta":{"image":"hero.tga"}})");
    write("d.json", R"({"frames":[{"frame":{"x":0,"y":0,"w":1,"h":1}}],)"
                    R"("meta":{"image":"hero.tga","frameTags":[{"name":"x","from":0,"to":5}]}})");
    for (const char* name : {"a.json", "b.json", "c.json", "d.json"})
        make("Sprite", {{"image", name}});
    step(1);
    CHECK(problems.size() == 4);
    CHECK(draw().size() == 4);
}

TEST_CASE_METHOD(Gallery, "an error in a file of Aseprite names the place and what was expected") {
    int count = 0;
    const auto broken = [&](const std::string& text, const std::string& problem) {
        CAPTURE(text);
        problems.clear();
        const std::string name = "broken_" + std::to_string(++count) + ".json";
        write(name, text);
        const Handle s = make("Sprite", {{"image", name}});
        step(1);
        CHECK(problems ==
              std::vector<std::string>{tree.path(s) + ".image: \"" + name +
                                       "\": is not a JSON export of Aseprite: " + problem});
    };
    const std::string frame = R"({"frame":{"x":0,"y":0,"w":1,"h":1}})";
    const auto with_tag = [&](const std::string& tag) {
        return R"({"frames":[)" + frame + "," + frame + R"(],"meta":{"image":"hero.tga",)" +
               R"("frameTags":[)" + tag + "]}}";
    };
    broken("[]", "expected an object, got a list");
    broken(std::string(100'000, '['), "nested deeper than 64 levels");
    broken(R"({"frames":[{"frame":{"x":"0"}}],"meta":{"image":"hero.tga"}})",
           "frames.0.frame.x: expected a number, got \"0\"");
    broken(R"({"frames":{"a":7},"meta":{"image":"hero.tga"}})",
           "frames.0: expected an object, got 7");
    broken(R"({"frames":[{}],"meta":{"image":"hero.tga"}})",
           "frames.0: expected an object with \"frame\", got an object");
    broken(R"({"frames":[],"meta":{"image":null}})", "meta.image: expected a text, got null");
    broken(with_tag(R"({"name":"x","from":0,"to":2})"),
           "meta.frameTags.0.to: expected a frame from 0 to 1, got 2");
    broken(with_tag(R"({"name":"x","from":-1,"to":1})"),
           "meta.frameTags.0.from: expected a frame from 0 to 1, got -1");
    broken(with_tag(R"({"name":"x","from":1,"to":0})"),
           "meta.frameTags.0.to: expected a frame that is not before \"from\", got 0");
}

TEST_CASE_METHOD(Gallery, "many long tags of a file of Aseprite are refused") {
    std::string frames, tags;
    for (int i = 0; i < 2000; ++i)
        frames += (i > 0 ? "," : "") + std::string(R"({"frame":{"x":0,"y":0,"w":1,"h":1}})");
    for (int i = 0; i < 2000; ++i)
        tags += (i > 0 ? "," : "") + std::string(R"({"name":"x","from":0,"to":1999})");
    write("a.json", R"({"frames":[)" + frames + R"(],"meta":{"image":"hero.tga","frameTags":[)" +
                        tags + "]}}");
    const Handle s = make("Sprite", {{"image", "a.json"}});
    step(1);
    CHECK(problems ==
          std::vector<std::string>{tree.path(s) +
                                   ".image: \"a.json\": its tags have more than 1000000 frames"});
}

TEST_CASE_METHOD(Gallery, "an incomplete image is reported as cut off") {
    write("empty.png", "");
    // The header of a PNG file of 8 by 8 pixels, and a part of the next name.
    const std::string header(
        "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x08\0\0\0\x08\x08\x06\0\0\0"
        "\xc4\x0f\xbe\x8b\0\0\0\x0bIDA",
        40);
    write("cut.png", header);
    make("Sprite", {{"image", "empty.png"}});
    make("Sprite", {{"image", "cut.png"}});
    step(1);
    REQUIRE(problems.size() == 2);
    CHECK_THAT(
        problems[0],
        contains("\"empty.png\": cannot be read as PNG, JPEG, BMP or TGA: the file is empty"));
    CHECK_THAT(problems[1], contains("BMP or TGA: it is cut off or damaged"));
}

TEST_CASE_METHOD(Gallery, "an image that is too large is refused before it is unpacked") {
    // Only the beginning of a PNG file, which says 12000 x 12000 pixels. Some releases of stb_image
    // read the size only where a part with pixels follows: a checksum, then the length and the name
    // of that part.
    const std::string png =
        std::string("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\x2e\xe0\0\0\x2e\xe0\x08\x06\0\0\0", 29) +
        std::string("\0\0\0\0\0\0\0\x08IDAT", 12) + std::string(20, '\0');
    write("large.png", png);
    const Handle s = make("Sprite", {{"image", "large.png"}});
    CHECK(tree.get(s, "image_width").integer() == 32);
    REQUIRE(problems.size() == 1);
    CHECK(problems[0] ==
          tree.path(s) +
              ".image: \"large.png\": has 12000 x 12000 pixels, and an image may have 67108864 "
              "(8192 x 8192)");
}

}  // namespace sprite_test
