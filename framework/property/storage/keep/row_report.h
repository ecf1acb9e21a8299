#pragma once
// Reports of rows that cannot be kept, and of the rows that depend on them.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/storage/tweaks.h>

#include <keep/row_paths.h>
#include <keep/row_stages.h>

namespace fettle::property {

class RowReport {
  public:
    explicit RowReport(TweakReport& report) : report_(report) {}

    void add_problem(const JournalRow& row, const std::string& reason) {
        // Messages about scene files contain paths from the top of the scene: "ball.mass: expected
        // ..."
        const std::string path = path_of(row), about = reason.substr(0, reason.find(": "));
        const bool same = about.size() < reason.size() && path.ends_with(about);
        report_.problems.push_back(path + (same ? reason.substr(about.size()) : ": " + reason));
    }
    void refuse(const JournalRow& row, const RowPaths& paths, const std::string& reason) {
        add_problem(row, reason);
        note_refused(row, paths);
    }
    template <class Keep>
    bool tried(const JournalRow& row, Keep keep_it) {
        try {
            keep_it();
            return true;
        } catch (const SceneError& error) {
            add_problem(row, error.reason());  // the position refers to a temporary text
        } catch (const Error& error) {
            add_problem(row, error.what());
        }
        return false;
    }
    /// Returns the rows that `keep_it` keeps; `begin` resets the text to the state before them. If
    /// a new instance cannot be kept, the rows below it and those that name it are not kept either.
    template <class Begin, class Keep>
    Rows tried_together(const Rows& rows, const RowPaths& paths, Begin begin, Keep keep_it) {
        Rows done;
        const std::size_t reported = count();
        std::vector<std::pair<const JournalRow*, std::string>> problems;
        for (bool again = true; again;) {
            again = false;
            done.clear();
            begin();
            forget_since(reported);
            for (const auto& [row, problem] : problems) report_.problems.push_back(problem);
            for (JournalRow* row : rows) {
                if (std::ranges::any_of(problems,
                                        [&](const auto& each) { return each.first == row; }))
                    continue;
                if (tried(*row, [&] {
                        require_made(*row, paths);
                        keep_it(*row);
                    })) {
                    done.push_back(row);
                } else {
                    problems.emplace_back(row, report_.problems.back());
                    note_refused(*row, paths);
                    again = again || std::ranges::any_of(done, [&](const JournalRow* each) {
                                return !missing_for(*each, paths).empty();
                            });
                }
            }
        }
        return done;
    }
    /// The value to be kept. A formula that is not saved is reported.
    Image kept_image(const JournalRow& row, const RowPaths& paths) {
        Image image = paths.live_image(row);
        if (image.kind == Image::Kind::formula && !image.not_saved.empty())
            report_.problems.push_back(path_of(row) + ": its formula " + image.not_saved +
                                       ", so its value is kept instead");
        return image;
    }

    /// `forget_since` removes the reports after the first `count` problems.
    std::size_t count() const { return report_.problems.size(); }
    void forget_since(std::size_t count) { report_.problems.resize(count); }

  private:
    void note_refused(const JournalRow& row, const RowPaths& paths) {
        if (row.kind == JournalRow::Kind::created) not_made_.push_back(paths.home(row));
    }
    void require_made(const JournalRow& row, const RowPaths& paths) const {
        if (const std::string path = missing_for(row, paths); !path.empty())
            throw Error(ErrorKind::rejected, "it depends on " + path + ", which is not kept");
    }
    /// A new instance that is not kept, and that the row needs; "": none.
    std::string missing_for(const JournalRow& row, const RowPaths& paths) const {
        for (const std::string& home : not_made_)
            if (paths.needs(row, home)) return without_marks(home);
        return {};
    }

    TweakReport& report_;
    std::vector<std::string> not_made_;  // home paths
};

}  // namespace fettle::property
