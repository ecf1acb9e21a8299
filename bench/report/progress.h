#pragma once
// How far a long run is: a bar on a terminal, plain lines elsewhere. On the error stream, so that
// tables and JSON lines stay clean.

#include <string>

namespace fettle::bench {

class Progress {
  public:
    /// `units` of work in all.
    explicit Progress(double units);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// A new piece of work begins: where there is no terminal, this makes a line.
    void begin(const std::string& what);
    void add(double units);

  private:
    void draw();
    void wipe();
    double units_;
    double done_ = 0;
    int shown_ = -1;  // tenths of a percent
    bool terminal_;
    std::string what_;
};

}  // namespace fettle::bench
