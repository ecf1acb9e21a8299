#pragma once
// A locale whose decimal point is a comma, as a program may have that Fettle is a part of.

#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "temporary_folder.h"

/// While it lives, the numbers of the functions of C have a comma, if the machine can make such a
/// locale.
class CommaLocale {
  public:
    CommaLocale() {
        const std::string made = "localedef -i de_DE -f UTF-8 '" +
                                 (folder_.path / "comma.UTF-8").string() + "' >/dev/null 2>&1";
        if (std::system(made.c_str()) == 0) {
            ::setenv("LOCPATH", folder_.path.c_str(), 1);
            there_ = std::setlocale(LC_NUMERIC, "comma.UTF-8") != nullptr &&
                     std::localeconv()->decimal_point[0] == ',';
            ::unsetenv("LOCPATH");
        }
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
