#include "vegetation/files/assimp_import.h"

#include "fluid/core/message.h"
#include "vegetation/fur/mesh.h"

#include <assimp/BaseImporter.h>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <exception>
#include <set>

namespace windrow::vegetation::fur {
namespace {

using windrow::detail::message;

// Serves the given bytes and nothing of the disk.
class MemoryFiles : public Assimp::IOSystem {
  public:
    explicit MemoryFiles(const std::map<std::string, std::string>& files) : files_(files) {}

    bool Exists(const char* name) const override { return files_.contains(plain(name)); }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream* Open(const char* name, const char* mode) override {
        const auto file = files_.find(plain(name));
        if (file == files_.end() || std::string_view(mode).find('w') != std::string_view::npos)
            return nullptr;
        return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(file->second.data()), file->second.size());
    }
    void Close(Assimp::IOStream* stream) override { delete stream; }

  private:
    static std::string plain(std::string_view name) { return std::string(name.substr(name.find_last_of('/') + 1)); }

    const std::map<std::string, std::string>& files_;
};

// Of its many importers only those of this ending: another would be tried on a file that this one rejects.
void keep_importers(Assimp::Importer& importer, const std::string& ending) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        Assimp::BaseImporter* const each = importer.GetImporter(i);
        std::set<std::string> endings;
        each->GetExtensionList(endings);
        if (!endings.contains(ending) && importer.UnregisterLoader(each) == aiReturn_SUCCESS)
            delete each; // it is ours from here on
    }
}

glm::vec3 vector(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

void add(SoupPart& part, const aiMesh& mesh, const aiMatrix4x4& place) {
    const aiMatrix3x3 turn(place);
    aiMatrix3x3 normals = turn;
    normals.Inverse().Transpose();
    const bool mirrors = turn.Determinant() < 0.0f;
    part.has_uv = mesh.HasTextureCoords(0);
    part.corners.reserve(3 * mesh.mNumFaces);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
        const aiFace& face = mesh.mFaces[i];
        if (face.mNumIndices != 3)
            continue; // points and lines
        for (unsigned k = 0; k < 3; ++k) {
            const unsigned at = face.mIndices[mirrors ? 2 - k : k];
            if (at >= mesh.mNumVertices)
                continue;
            Corner corner{vector(place * mesh.mVertices[at])};
            if (mesh.HasNormals())
                corner.normal = vector(normals * mesh.mNormals[at]);
            if (part.has_uv)
                corner.uv = {mesh.mTextureCoords[0][at].x, mesh.mTextureCoords[0][at].y};
            part.corners.push_back(corner);
        }
        part.corners.resize(part.corners.size() - part.corners.size() % 3);
    }
}

// What stands in a node and below it; false: too much.
bool gather(Soup& soup, std::size_t& corners, const aiScene& scene, const aiNode& node, const aiMatrix4x4& above) {
    const aiMatrix4x4 place = above * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
        corners += std::size_t{3} * mesh.mNumFaces;
        if (corners > 3 * k_max_triangles || soup.size() == k_max_parts)
            return false;
        const bool named = mesh.mMaterialIndex < scene.mNumMaterials;
        add(soup.emplace_back(SoupPart{named ? scene.mMaterials[mesh.mMaterialIndex]->GetName().C_Str() : "none", {}, false}),
            mesh, place);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        if (!gather(soup, corners, scene, *node.mChildren[i], place))
            return false;
    return true;
}

} // namespace

windrow::Result<Soup> import_soup(const std::map<std::string, std::string>& files, const std::string& name,
                                  const std::string& owner) try {
    const std::string ending = name.substr(name.find_last_of('.') + 1);
    Assimp::Importer importer;
    keep_importers(importer, ending);
    importer.SetIOHandler(new MemoryFiles(files)); // the importer destroys it
    const aiScene* scene = importer.ReadFile(name, ending == "obj" ? static_cast<unsigned>(aiProcess_Triangulate) : 0u);
    if (scene == nullptr || scene->mRootNode == nullptr)
        return windrow::Error{
            message(owner, " is not a mesh that Assimp reads: ", importer.GetErrorString(), ": give another file.")};
    Soup soup;
    std::size_t corners = 0;
    if (!gather(soup, corners, *scene, *scene->mRootNode, aiMatrix4x4()))
        return windrow::Error{message(owner, " has more than ", k_max_triangles, " triangles or ", k_max_parts,
                                      " parts, counting each place: give fewer.")};
    std::erase_if(soup, [](const SoupPart& part) { return part.corners.empty(); });
    if (soup.empty())
        return windrow::Error{message(owner, " has no triangles: give a mesh of triangles.")};
    return soup;
} catch (const std::exception& fault) { // of its own Assimp lets none out, but memory may end
    return windrow::Error{message(owner, " cannot be read: ", fault.what(), ": give a smaller file.")};
}

} // namespace windrow::vegetation::fur
