#include <prompt/text_edit.h>

#include <text/utf8.h>
#include "catch.h"

namespace text_edit_test {

using fettle::console::clean_text;
using fettle::console::lua_string;
using fettle::console::Motion;
using fettle::console::TextEdit;

TEST_CASE("typing replaces the selection") {
    TextEdit edit;
    edit.insert("world.ball");
    edit.select(6, 10);
    edit.insert("x");
    CHECK(edit.text() == "world.x");
    CHECK(edit.cursor() == 7);
    CHECK_FALSE(edit.selecting());
}

TEST_CASE("the cursor moves by whole characters and words") {
    TextEdit edit;
    edit.insert("für world.ball");
    edit.move(Motion::text_start, false);
    edit.move(Motion::right, false);
    edit.move(Motion::right, false);
    CHECK(edit.cursor() == 3);  // after f and the two bytes of ü
    edit.move(Motion::left, false);
    CHECK(edit.cursor() == 1);
    edit.move(Motion::word_right, false);
    CHECK(edit.cursor() == 4);
    edit.move(Motion::word_right, true);
    CHECK(edit.selected() == " world");
    edit.move(Motion::right, false);
    CHECK(edit.cursor() == 10);  // to the end of the selection
    edit.erase(Motion::word_left);
    CHECK(edit.text() == "für .ball");
}

TEST_CASE("up and down keep the column where the line is long enough") {
    TextEdit edit;
    edit.insert("long line\nab\nlong again");
    edit.place(7, false);
    edit.move(Motion::line_down, false);
    CHECK(edit.cursor() == 12);
    CHECK(edit.line_of(edit.cursor()) == 1);
    edit.move(Motion::line_up, true);
    CHECK(edit.column_of(edit.cursor()) == 2);
    edit.move(Motion::text_end, false);
    CHECK(edit.line_of(edit.cursor()) == 2);
    CHECK(edit.line(1) == "ab");
    CHECK(edit.line_count() == 3);
}

TEST_CASE("undo removes one word at a time and redo adds it again") {
    TextEdit edit;
    for (const char* c : {"a", "b", " ", "c", "d"}) edit.insert(c);
    CHECK(edit.undo());
    CHECK(edit.text() == "ab ");
    CHECK(edit.undo());
    CHECK(edit.undo());
    CHECK(edit.text().empty());
    CHECK_FALSE(edit.undo());
    CHECK(edit.redo());
    CHECK(edit.text() == "ab");
    edit.insert("x");
    CHECK_FALSE(edit.redo());
}

TEST_CASE("deleting without a selection deletes the text that the motion passes") {
    TextEdit edit;
    edit.insert("one two");
    edit.erase(Motion::left);
    CHECK(edit.text() == "one tw");
    edit.erase(Motion::word_left);
    CHECK(edit.text() == "one ");
    edit.erase(Motion::line_start);
    CHECK(edit.empty());
    edit.erase(Motion::left);
    edit.erase(Motion::right);
    CHECK(edit.empty());
}

TEST_CASE("a text longer than the limit is cut between characters") {
    TextEdit edit;
    edit.insert(std::string(TextEdit::max_bytes - 1, 'x'));
    edit.insert("ü");
    CHECK(edit.text().size() == TextEdit::max_bytes - 1);
    edit.insert("y");
    edit.insert("z");
    CHECK(edit.text().size() == TextEdit::max_bytes);
    CHECK(edit.text().back() == 'y');
}

TEST_CASE("characters that a line cannot contain are removed from pasted text") {
    CHECK(clean_text("a\r\nb\rc\td\x07") == "a\nb\nc  d");
    CHECK(clean_text("ü→") == "ü→");
    CHECK(clean_text("\xff\xc3") == "\xef\xbf\xbd\xef\xbf\xbd");
    CHECK(clean_text("\xc0\x80\xed\xa0\x80") ==
          "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");
    CHECK(clean_text(std::string_view("a\0b", 3)) == "ab");
}

TEST_CASE("the selection of a word includes underscores and digits") {
    TextEdit edit;
    edit.insert("world.body_1.mass");
    edit.select_word(8);
    CHECK(edit.selected() == "body_1");
    edit.select_word(5);
    CHECK(edit.selected() == "world");
    edit.select_word(17);
    CHECK(edit.selected() == "mass");
}

TEST_CASE("every text is a literal of Lua that has its value") {
    CHECK(lua_string("a\"b\\c\nd\re") == "\"a\\\"b\\\\c\\\nd\\re\"");
}

}  // namespace text_edit_test
