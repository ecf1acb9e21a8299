#pragma once
// A locale whose decimal point is a comma, as a program may have that Fettle is a part of.

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "temporary_folder.h"

/// While it lives, the numbers of the functions of C have a comma, if the machine can make such a
/// locale.
class CommaLocale {
  public:
    CommaLocale() {
        // Only its numbers differ from those of C. With a table of characters of its own, no
        // package with locales is needed, and it is made in a hundredth of the time of a whole one.
        std::ofstream(folder_.path / "comma")
            << "LC_NUMERIC\ndecimal_point \"<U002C>\"\n"
               "thousands_sep \"<U002E>\"\ngrouping 3;3\nEND LC_NUMERIC\n";
        std::ofstream(folder_.path / "ascii") << "<code_set_name> ASCII\n<escape_char> /\nCHARMAP\n"
                                                 "<U0000>..<U007F> /x00 ALL\nEND CHARMAP\n";
        // Its status is that of warnings: the other categories are missing.
        static_cast<void>(
            std::system(("cd '" + folder_.path.string() +
                         "' && localedef -c -i ./comma -f ./ascii ./with_comma >/dev/null 2>&1")
                            .c_str()));
        ::setenv("LOCPATH", folder_.path.c_str(), 1);
        there_ = std::setlocale(LC_NUMERIC, "with_comma") != nullptr &&
                 std::localeconv()->decimal_point[0] == ',';
        ::unsetenv("LOCPATH");
        if (!there_) std::cout << "SKIPPED: no locale with a comma can be made (localedef)\n";
    }
    ~CommaLocale() { std::setlocale(LC_NUMERIC, "C"); }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

    bool there() const { return there_; }

  private:
    TemporaryFolder folder_;
    bool there_ = false;
};
