// Garments from files, and the materials that say what of them is simulated.

#include "demo/character/garment/garment_file.h"

#include "tests/demo/character/temporary_file.h"
#include "tests/demo/garments.h"

namespace weft::demo {
namespace {

/// A strip of four rows of two vertices: the upper quad is of `upper`, the two lower ones of `lower`. Its
/// seventh vertex is used by nothing.
std::string strip(const std::string& head, const std::string& upper, const std::string& lower) {
    return head + "v 0 1.2 0\nv 0.2 1.2 0\nv 0 1 0\nv 0.2 1 0.1\nv 0 0.8 0\nv 0.2 0.8 0.2\nv 9e-1 1 0\n" +
           upper + "f 1 3 4 2\n" + lower + "f 3 5 6\nf -5 -2 -4\n";
}

std::string refusal_of(const std::string& text) {
    const TemporaryFile file("refused.obj", text);
    const auto garment = read_garment(file.path());
    return garment.ok() ? std::string() : garment.error().message;
}

TEST(GarmentFile, FixesWhatIsOfNoFreeMaterial) {
    const TemporaryFile materials("cloth.mtl", "newmtl Top\nKd 1 1 1\nnewmtl Silk Free\nKd 0.2 0.4 0.6\n");
    const TemporaryFile file("strip.obj", strip("mtllib " + materials.path().filename().string() + "\n",
                                                "usemtl Top\n", "usemtl Silk Free\n"));
    const auto garment = read_garment(file.path());
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    EXPECT_EQ(garment->fixed, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_TRUE(garment->stands_ready);
    EXPECT_TRUE(garment->notes.empty()) << garment->notes.front();
    EXPECT_FLOAT_EQ(garment->colour.x, 0.2f);
    EXPECT_FLOAT_EQ(garment->colour.z, 0.6f);
    EXPECT_EQ(garment->mesh.triangles.size(), 4u);
    EXPECT_FLOAT_EQ(garment->mesh.positions[1].y, 1.2f) << "+Y stays up";
}

TEST(GarmentFile, GoesOnWithoutItsMaterialsFile) {
    const TemporaryFile file("alone.obj",
                             strip("mtllib not here.mtl\n", "usemtl Top\n", "usemtl SilkFree\n"));
    const auto garment = read_garment(file.path());
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    EXPECT_EQ(garment->fixed, (std::vector<std::uint32_t>{0, 1}));
    ASSERT_EQ(garment->notes.size(), 1u);
    EXPECT_NE(garment->notes[0].find("not here.mtl cannot be read"), std::string::npos);
    EXPECT_FLOAT_EQ(garment->colour.x, Garment().colour.x);

    const TemporaryFile materials("other.mtl", "newmtl SilkFree\nKd 0 1 0\n");
    const TemporaryFile lacking("lacking.obj", strip("mtllib " + materials.path().filename().string() + "\n",
                                                     "usemtl Top\n", "usemtl SilkFree\n"));
    const auto other = read_garment(lacking.path());
    ASSERT_TRUE(other.ok());
    ASSERT_EQ(other->notes.size(), 1u);
    EXPECT_NE(other->notes[0].find("has no material Top"), std::string::npos);

    const TemporaryFile none("none.obj", strip("", "usemtl Top\n", "usemtl SilkFree\n"));
    ASSERT_EQ(read_garment(none.path())->notes.size(), 1u);
}

TEST(GarmentFile, NotesOutlinesThatCrossThemselves) {
    const TemporaryFile materials("whole.mtl", "newmtl Top\nnewmtl SilkFree\n");
    const std::string text =
        strip("mtllib " + materials.path().filename().string() + "\n", "usemtl Top\n", "usemtl SilkFree\n") +
        "v 0 0.6 0\nv 0.2 0.6 0\nv 0.2 0.4 0\nv 0 0.4 0\n";
    EXPECT_TRUE(read_garment(TemporaryFile("square.obj", text + "f -4 -3 -2 -1\n").path())->notes.empty());
    const auto crossing = read_garment(TemporaryFile("bow_tie.obj", text + "f -4 -2 -3 -1\n").path());
    ASSERT_TRUE(crossing.ok());
    ASSERT_EQ(crossing->notes.size(), 1u);
    EXPECT_NE(crossing->notes[0].find("cross themselves: 1;"), std::string::npos);
}

TEST(GarmentFile, FacesBeforeTheFirstMaterialAreFixed) {
    const TemporaryFile file("first.obj", strip("", "", "usemtl SkirtFree\n"));
    EXPECT_EQ(read_garment(file.path())->fixed, (std::vector<std::uint32_t>{0, 1}));
    const TemporaryFile all("all.obj", strip("", "usemtl TopFree\n", "usemtl SkirtFree\n"));
    EXPECT_TRUE(read_garment(all.path())->fixed.empty());
}

TEST(GarmentFile, WithoutMaterialsIsTurnedUprightAndHeldByItsOpening) {
    WEFT_NEEDS_DATA();
    for (const auto& [name, from_waist, held] : {std::tuple("skirt-iso", true, 48u),
                                                 {"tshirt-iso", false, 30u},
                                                 {"dress-victor-iso-draped", false, 18u}}) {
        const auto garment = read_garment(data_folder() / "garments" / (std::string(name) + ".obj"));
        ASSERT_TRUE(garment.ok()) << garment.error().message;
        EXPECT_EQ(garment->from_waist, from_waist) << name;
        EXPECT_EQ(garment->fixed.size(), held) << name;
        EXPECT_FALSE(garment->stands_ready);
        EXPECT_FALSE(garment->mesh.pattern.empty());
    }
}

TEST(GarmentFile, AMillimetreFileFitsByItsSize) {
    const TemporaryFile file("millimetres.obj", "v 0 0 0\nv 900 0 0\nv 0 400 0\nusemtl aFree\nf 1 2 3\n");
    const auto garment = read_garment(file.path(), 0);
    ASSERT_TRUE(garment.ok()) << garment.error().message;
    EXPECT_NEAR(garment->mesh.positions[1].x, 0.9f, 1e-6f);
    EXPECT_FALSE(read_garment(file.path()).ok()) << "nobody wears 900 m";
}

TEST(GarmentFile, ErrorsNameWhatIsWrong) {
    EXPECT_NE(refusal_of(strip("", "usemtl Top\n", "usemtl Bottom\n"))
                  .find("Top and others, none ends in \"Free\""),
              std::string::npos);
    EXPECT_NE(refusal_of("v 0 0 0\nv 100 0 0\nv 0 1 0\nusemtl aFree\nf 1 2 3\n").find("100.000000 m along x"),
              std::string::npos);
    EXPECT_NE(refusal_of("v 0 0 0\nv 0.05 0 0\nv 0 0.02 0\nusemtl aFree\nf 1 2 3\n")
                  .find("0.050000 m along x, its longest side"),
              std::string::npos);
    EXPECT_EQ(refusal_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl aFree\nf 1 2 3\n"), "") << "flat in z";
    EXPECT_NE(refusal_of("v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n").find(":2:"), std::string::npos);
    const auto missing = read_garment("no/such.obj");
    ASSERT_FALSE(missing.ok());
    EXPECT_EQ(missing.error().code, ErrorCode::file_not_found);
}

}  // namespace
}  // namespace weft::demo
