// A host that draws with OGRE 1.12: a flag, whose vertices Weft writes into OGRE's locked vertex buffer. It
// leaves a picture: weft_embed_ogre PICTURE.png

#include <Ogre.h>
#include <weft/weft.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

namespace {

template <class T>
T need(weft::Result<T> result) {
    if (!result) std::fprintf(stderr, "%s\n", result.error().message.c_str()), std::exit(1);
    if constexpr (!std::is_void_v<T>) return *std::move(result);
}

// A cloth as OGRE's mesh: positions, normals and texture coordinates in one buffer, written each frame.
class ClothMesh {
  public:
    ClothMesh(const weft::Mesh& from, const std::string& material) {
        mesh_ = Ogre::MeshManager::getSingleton().createManual("cloth", Ogre::RGN_DEFAULT);
        auto* const vertices = new Ogre::VertexData();  // the mesh deletes it
        mesh_->sharedVertexData = vertices;
        vertices->vertexCount = from.positions.size();
        vertices->vertexDeclaration->addElement(0, 0, Ogre::VET_FLOAT3, Ogre::VES_POSITION);
        vertices->vertexDeclaration->addElement(0, 12, Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
        vertices->vertexDeclaration->addElement(0, 24, Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
        auto& buffers = Ogre::HardwareBufferManager::getSingleton();
        buffer_ = buffers.createVertexBuffer(stride, vertices->vertexCount,
                                             Ogre::HardwareBuffer::HBU_DYNAMIC_WRITE_ONLY_DISCARDABLE);
        vertices->vertexBufferBinding->setBinding(0, buffer_);
        Ogre::SubMesh* const part = mesh_->createSubMesh();
        part->setMaterialName(material);
        part->indexData->indexCount = 3 * from.triangles.size();  // counter-clockwise fronts, as OGRE's
        part->indexData->indexBuffer =
            buffers.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, part->indexData->indexCount,
                                      Ogre::HardwareBuffer::HBU_STATIC_WRITE_ONLY);
        part->indexData->indexBuffer->writeData(0, part->indexData->indexBuffer->getSizeInBytes(),
                                                from.triangles.data());
        mesh_->load();
    }
    void write(const weft::World& world, weft::ClothId cloth) {
        const std::span to(static_cast<std::byte*>(buffer_->lock(Ogre::HardwareBuffer::HBL_DISCARD)),
                           buffer_->getSizeInBytes());
        need(world.write_vertices(cloth, {.positions = {to, stride},
                                          .normals = {to.subspan(12), stride},
                                          .texcoords = {to.subspan(24), stride}}));
        buffer_->unlock();
        const auto [lower, upper] = need(world.cloth(cloth)).bounds;
        mesh_->_setBounds({lower.x, lower.y, lower.z, upper.x, upper.y, upper.z});
    }
    [[nodiscard]] const Ogre::MeshPtr& mesh() const { return mesh_; }

  private:
    static constexpr std::size_t stride = 32;  // of a vertex [bytes]
    Ogre::MeshPtr mesh_;
    Ogre::HardwareVertexBufferSharedPtr buffer_;
};

// Share of the window's pixels that are not of the background, which is blue.
double drawn_share(const Ogre::RenderWindow& window) {
    std::vector<unsigned char> pixels(std::size_t{3} * window.getWidth() * window.getHeight());
    const Ogre::PixelBox box(window.getWidth(), window.getHeight(), 1, Ogre::PF_BYTE_RGB, pixels.data());
    const_cast<Ogre::RenderWindow&>(window).copyContentsToMemory(box, box);
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 3) drawn += pixels[i] > pixels[i + 2] ? 1 : 0;
    return static_cast<double>(drawn) / static_cast<double>(pixels.size() / 3);
}

}  // namespace

int main(int count, char** arguments) {
    const std::string picture = count > 1 ? arguments[1] : "ogre.png";
    Ogre::Root root("", "", "");
    for (const char* plugin : {"RenderSystem_GL", "Codec_STBI"})
        root.loadPlugin(std::string(WEFT_OGRE_PLUGINS "/") + plugin);
    root.setRenderSystem(root.getAvailableRenderers().front());
    root.initialise(false);
    const Ogre::NameValuePairList options{{"FSAA", "4"}};
    Ogre::RenderWindow* const window = root.createRenderWindow("Weft", 800, 600, false, &options);

    Ogre::SceneManager* const scene = root.createSceneManager();
    scene->setAmbientLight(Ogre::ColourValue(0.35f, 0.35f, 0.35f));
    scene->createLight("sun")->setType(Ogre::Light::LT_DIRECTIONAL);
    scene->getRootSceneNode()->createChildSceneNode()->attachObject(scene->getLight("sun"));
    scene->getLight("sun")->getParentSceneNode()->setDirection(Ogre::Vector3(-0.3f, -0.5f, -1));
    Ogre::Camera* const camera = scene->createCamera("camera");
    camera->setNearClipDistance(0.1f);
    Ogre::SceneNode* const eye =
        scene->getRootSceneNode()->createChildSceneNode(Ogre::Vector3(0.8f, 1.4f, 3.2f));
    eye->attachObject(camera);
    eye->lookAt(Ogre::Vector3(0.8f, 1.4f, 0), Ogre::Node::TS_WORLD);
    window->addViewport(camera)->setBackgroundColour(Ogre::ColourValue(0.25f, 0.35f, 0.6f));
    const Ogre::MaterialPtr red = Ogre::MaterialManager::getSingleton().create("red", Ogre::RGN_DEFAULT);
    red->setDiffuse(0.85f, 0.2f, 0.12f, 1);
    red->setAmbient(0.85f, 0.2f, 0.12f);
    red->setCullingMode(Ogre::CULL_NONE);

    weft::WorldSettings settings;
    settings.wind = {.velocity = {4, 0, 1.5f}, .gust = 0.3f};
    weft::World world = need(weft::World::create(settings));
    const weft::Mesh sheet = need(weft::make_sheet(
        {.rows = 32, .columns = 48, .origin = {0, 2, 0}, .u = {1.5f, 0, 0}, .v = {0, -1, 0}}));
    const weft::ClothId cloth = need(world.add_cloth(sheet));
    for (std::uint32_t row = 0; row < sheet.rows; ++row) need(world.pin(cloth, row * sheet.columns));
    ClothMesh mesh(sheet, "red");
    mesh.write(world, cloth);
    scene->getRootSceneNode()->attachObject(scene->createEntity(mesh.mesh()));

    for (int frame = 0; frame < 120; ++frame) {
        world.step(1.0f / 60);
        mesh.write(world, cloth);
        root.renderOneFrame();
    }
    window->writeContentsToFile(picture);
    const double share = drawn_share(*window);
    std::printf("%s: cloth is on %.1f %% of it\n", picture.c_str(), 100 * share);
    return share > 0.02 && share < 0.6 ? 0 : 1;
}
