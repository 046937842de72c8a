// Makes a test of the guide: extract OUTPUT PAGE.md.. writes a file with one test a page. A page's blocks of
// ```cpp become one function; those of ```cpp top stand before it, their includes at the head of the file.
// What a reader does not see, <!-- check: .. -->, is taken over as it stands.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

namespace {

struct Page {
    std::string includes, top, body;
    bool has_main = false;
};

Page read(const std::filesystem::path& file) {
    Page page;
    std::ifstream in(file);
    enum class In { text, top, body, other } where = In::text;
    constexpr std::string_view main_of = "int main()", check = "<!-- check: ", end_of_check = "-->";
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.starts_with("```")) {
            if (where != In::text)
                where = In::text;
            else
                where = line == "```cpp" ? In::body : line == "```cpp top" ? In::top : In::other;
            const std::string place = "#line " + std::to_string(number + 1) + " \"" + file.string() + "\"\n";
            if (where == In::body) page.body += place;
            if (where == In::top) page.top += place;
        } else if (where == In::text && line.starts_with(check)) {
            line.erase(0, check.size());
            page.body += "#line " + std::to_string(number) + " \"" + file.string() + "\"\n";
            page.body += line.substr(0, line.rfind(end_of_check)) + '\n';
        } else if (where == In::top) {
            if (line.starts_with("#include")) {
                page.includes += line + '\n';
                line.clear();
            }
            if (const auto at = line.find(main_of); at != std::string::npos) {
                line.replace(at, main_of.size(), "int whole_program()");
                page.has_main = true;
            }
            page.top += line + '\n';
        } else if (where == In::body) {
            page.body += line + '\n';
        }
    }
    return page;
}

std::string name_of(const std::filesystem::path& file) {
    std::string name = file.stem().string();
    std::ranges::replace(name, '-', '_');
    return name;
}

}  // namespace

int main(int count, char** arguments) {
    std::string head, tests;
    for (int i = 2; i < count; ++i) {
        const std::filesystem::path file = arguments[i];
        const Page page = read(file);
        if (page.body.empty() && page.top.empty()) continue;
        head += page.includes;
        tests += "namespace page_" + name_of(file) + " {\n" + page.top + "void page() {\n";
        if (page.has_main) tests += "EXPECT_EQ(whole_program(), 0);\n";
        tests += page.body + "}\n}\n#line 1 \"examples.cpp\"\nTEST(Guide, " + name_of(file) + ") { page_" +
                 name_of(file) + "::page(); }\n";
    }
    std::ofstream out(arguments[1]);
    out << head << "#include \"tests/guide/host.h\"\n" << tests;
    return out.flush() && !tests.empty() ? 0 : 1;
}
