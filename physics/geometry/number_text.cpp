#include <geometry/number_text.h>

#include <locale>
#include <sstream>

namespace fettle::physics::detail {

std::string number_text(double number, int digits) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << number;
    return out.str();
}

std::string exact_text(float number) {
    std::string text = number_text(double(number));
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    float read = 0;
    in >> read;
    return read == number ? text : number_text(double(number), 9);
}

}  // namespace fettle::physics::detail
