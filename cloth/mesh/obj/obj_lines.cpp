#include "cloth/mesh/obj/obj_lines.h"

namespace weft {

namespace {

constexpr int end_of_file = std::char_traits<char>::eof();
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

ObjLines::ObjLines(std::istream& stream, const std::string& file) : stream_(*stream.rdbuf()), file_(file) {}

bool ObjLines::at_end() const {
    return stream_.sgetc() == end_of_file;
}

Error ObjLines::error_at(std::size_t line, const std::string& message) const {
    return {ErrorCode::malformed_file, file_ + ":" + std::to_string(line) + ": " + message};
}

Result<bool> ObjLines::next() {
    text_.clear();
    if (at_end()) return false;
    line_ = lines_read_ + 1;
    for (bool continues = true; continues && !at_end();) {
        if (!append_line())
            return error("the line is longer than " + std::to_string(most_characters) +
                         " characters; an OBJ file's are not");
        continues = text_.ends_with('\\');
        if (continues) text_.back() = ' ';
    }
    return true;
}

// Comments are removed before next() looks for a trailing backslash: many a comment ends in a Windows path.
bool ObjLines::append_line() {
    ++lines_read_;
    bool comment = false;
    for (int c = stream_.sbumpc(); c != end_of_file && c != '\n'; c = stream_.sbumpc()) {
        if (c == '\r') {
            if (stream_.sgetc() == '\n') stream_.sbumpc();
            break;
        }
        comment |= c == '#';
        if (comment) continue;
        if (text_.size() == most_characters) return false;
        text_.push_back(static_cast<char>(c));
    }
    if (lines_read_ == 1 && text_.starts_with(byte_order_mark)) text_.erase(0, byte_order_mark.size());
    return true;
}

}  // namespace weft
