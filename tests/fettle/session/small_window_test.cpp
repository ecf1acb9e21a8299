// Texts that games of `scripts/` draw on the screen, in windows of several sizes.

#include <catch.h>

#include "program.h"

namespace small_window_test {

using namespace program_test;

TEST_CASE("the texts of games fit into small windows and do not cover each other") {
    const char* const game = GENERATE("car", "ragdoll", "showcase", "sounds", "quarry");
    const char* const size = GENERATE("400, 300", "800, 600", "1280, 800");
    INFO(game << " in " << size);
    // Each letter counts as half as wide as high. The pen notes texts on the screen only.
    const std::string look = R"(
        local found, on_screen = {}, false
        local pen = {}
        setmetatable(pen, { __index = function() return function() end end })
        function pen.screen(action) on_screen = true action(pen) on_screen = false end
        function pen.text_size(text, size, font, wrap)
            local width, widest, lines = 0, 0, 1
            for word, space in text:gmatch('(%S+)(%s*)') do
                if wrap and width > 0 and width + #word * size / 2 > wrap then width, lines = 0, lines + 1 end
                widest = math.max(widest, width + #word * size / 2)
                width = width + #(word .. space) * size / 2
            end
            return widest, lines * size
        end
        function pen.text(at, text, size, fill, align, font, wrap)
            if not on_screen then return end
            local wide, high = pen.text_size(text, size or 16, font, wrap)
            local left = align == "left" and at.x or align == "right" and at.x - wide or at.x - wide / 2
            local one = { left, at.y - high / 2, left + wide, at.y + high / 2, text }
            if one[1] < 0 or one[2] < 0 or one[3] > view.screen.x or one[4] > view.screen.y then
                print("cut: " .. text)
            end
            for _, other in ipairs(found) do
                if one[1] < other[3] and other[1] < one[3] and one[2] < other[4] and other[2] < one[4] then
                    print(text .. " covers " .. other[5])
                end
            end
            found[#found + 1] = one
        end
        draw(pen)
        print(#found > 1)
    )";
    const Outcome done = fettle(
        Folder(), {"run", std::string("scripts/") + game, "--headless", "--steps", "4", "--at",
                   std::string("1:view.window.size = vec(") + size + ")", "--at", "3:" + look});
    INFO(done.err);  // may list tweaks that were made in the demo on this machine
    CHECK(done.status == 0);
    CHECK(done.out == "true\n");
}

TEST_CASE("the texts of the showcase are hidden while the console covers a part of them") {
    const std::string look = R"(
        local texts = 0
        local pen = setmetatable({}, { __index = function() return function() end end })
        function pen.screen(action) action(pen) end
        function pen.text_size(text, size) return #text * size / 2, size end
        function pen.text() texts = texts + 1 end
        draw(pen)
        print(texts > 0)
    )";
    const Outcome done =
        fettle(Folder(), {"run", "scripts/showcase", "--headless", "--steps", "4", "--at",
                          "1:" + look, "--at", "2:console.open = true", "--at", "3:" + look});
    INFO(done.err);
    CHECK(done.out == "true\nfalse\n");
}

}  // namespace small_window_test
