#include "report/json_lines.h"

#include <nlohmann/json.hpp>

namespace fettle::bench {

std::string json_line(std::initializer_list<std::pair<const char*, JsonField>> fields) {
    nlohmann::ordered_json line;
    for (const auto& [name, field] : fields) {
        if (const auto* text = std::get_if<std::string>(&field))
            line[name] = *text;
        else if (const auto* number = std::get_if<double>(&field))
            line[name] = *number;
        else if (const auto* integer = std::get_if<long long>(&field))
            line[name] = *integer;
        else
            line[name] = nullptr;
    }
    return line.dump();
}

}  // namespace fettle::bench
