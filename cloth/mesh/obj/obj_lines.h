#pragma once
// OBJ text, statement by statement, read in a stream: a file needs no more memory than its longest line.

#include <cstddef>
#include <istream>
#include <string>
#include <string_view>

#include "weft/error.h"

namespace weft {

class ObjLines {
  public:
    /// The most characters of a statement without its comments. No OBJ file has longer statements.
    static constexpr std::size_t most_characters = std::size_t{1} << 20;

    /// `file` is the name that errors give the stream. Both must outlive this.
    ObjLines(std::istream& stream, const std::string& file);

    /// Advances to the next statement; false at the end. Lines that a backslash joins are one statement.
    /// Error: a statement that is too long.
    [[nodiscard]] Result<bool> next();
    /// The statement, without comments and line ends (LF, CR LF or CR).
    [[nodiscard]] std::string_view text() const noexcept { return text_; }

    /// "FILE:LINE: message", by the present statement's first line, counted from 1.
    [[nodiscard]] Error error(const std::string& message) const { return error_at(line_, message); }
    [[nodiscard]] Error error_at(std::size_t line, const std::string& message) const;
    [[nodiscard]] std::size_t line() const noexcept { return line_; }

  private:
    /// Appends a line of the file to the text. False: the text has become too long.
    [[nodiscard]] bool append_line();
    [[nodiscard]] bool at_end() const;

    std::streambuf& stream_;
    const std::string& file_;
    std::string text_;
    std::size_t line_ = 0, lines_read_ = 0;
};

}  // namespace weft
