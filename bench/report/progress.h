#pragma once
// Progress of a long run: a bar on a terminal, otherwise plain lines. It is written to the error
// stream, so that tables and JSON lines contain nothing else.

#include <string>

namespace fettle::bench {

class Progress {
  public:
    /// `units`: total amount of work.
    explicit Progress(double units);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Begins a new part of the work; without a terminal this prints a line.
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
