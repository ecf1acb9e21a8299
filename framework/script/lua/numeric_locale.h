#pragma once
// Numbers in texts have a point, whatever the locale of the program is.

#include <clocale>  // also that of POSIX
#include <cstring>

namespace fettle::script {

/// While it lives, the functions of C write and read the numbers of this thread as in the locale
/// "C". Lua uses them for `"x" .. 1.5` and string.format, and games store such texts.
class NumericLocale {
  public:
    NumericLocale() {
        if (std::strcmp(std::localeconv()->decimal_point, ".") == 0) return;
        before_ = ::uselocale(nullptr);
        locale_t copy = ::duplocale(before_);
        if (copy == nullptr) return;
        own_ = ::newlocale(LC_NUMERIC_MASK, "C", copy);
        if (own_ == nullptr)
            ::freelocale(copy);
        else
            ::uselocale(own_);
    }
    ~NumericLocale() {
        if (own_ == nullptr) return;
        ::uselocale(before_);
        ::freelocale(own_);
    }
    NumericLocale(const NumericLocale&) = delete;
    NumericLocale& operator=(const NumericLocale&) = delete;

  private:
    locale_t before_ = nullptr, own_ = nullptr;
};

}  // namespace fettle::script
