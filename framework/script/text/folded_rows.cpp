#include <algorithm>
#include <iterator>

#include <text/folded_rows.h>

namespace fettle::script {

void fold_rows(std::vector<std::string>& lines, const Rows& rows, FoldedLines& folded) {
    if (rows.total <= rows.shown) return;
    const std::size_t kept = std::min(lines.size(), rows.before + rows.shown);
    const auto rest = lines.begin() + static_cast<std::ptrdiff_t>(kept);
    const std::size_t more = rows.total - rows.shown;
    folded.line = kept;
    folded.lines.assign(std::make_move_iterator(rest),
                        std::make_move_iterator(rest + static_cast<std::ptrdiff_t>(std::min(
                                                           max_folded, lines.size() - kept))));
    lines.erase(rest, lines.end());
    if (more > folded.lines.size())
        folded.lines.push_back("… " + std::to_string(more - folded.lines.size()) + " more");
    lines.push_back("… " + std::to_string(more) + " more (" + std::to_string(rows.total) + " " +
                    rows.what + ")");
}

}  // namespace fettle::script
