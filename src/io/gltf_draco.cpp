#include "io/gltf_draco.hpp"

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/geometry_metadata.h>
#include <draco/metadata/metadata_decoder.h>

#include <cstring>

#include "io/accessors.hpp"

namespace facet::io {

namespace {

using tinygltf::Value;

constexpr const char* dracoExtension = "KHR_draco_mesh_compression";
constexpr const char* dracoRemedy = "export the model again, or without Draco compression";

std::string placeOf(const std::string& primitive) { return primitive + "/extensions/" + dracoExtension; }

// ---- Counts, before anything is allocated for them ------------------------------------------------------------------

struct Counts {
  uint32_t triangles = 0;
  uint32_t points = 0;  // 0: only known after decoding (edgebreaker splits points at seams)
};

// A flat grid takes next to nothing a triangle once its symbols are known, so only gross lies show.
constexpr uint64_t largestTrianglesPerByte = 16384;

// The bitstream's header, metadata and the first numbers of its connectivity (Draco bitstream specification 2.2,
// sections 3.1 to 3.4). Gives a problem where it is not such a mesh.
tl::expected<Counts, std::string> readCounts(std::span<const uint8_t> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok())
    return tl::unexpected<std::string>("is not Draco data");
  if (header.encoder_type != draco::TRIANGULAR_MESH) return tl::unexpected<std::string>("holds no mesh");
  const int major = header.version_major, minor = header.version_minor;
  if (major != draco::kDracoMeshBitstreamVersionMajor || minor != draco::kDracoMeshBitstreamVersionMinor) {
    return tl::unexpected<std::string>("has the Draco bitstream version " + std::to_string(major) + "." +
                                       std::to_string(minor) + "; glTF allows only 2.2");
  }
  buffer.set_bitstream_version(draco::kDracoMeshBitstreamVersion);
  if ((header.flags & METADATA_FLAG_MASK) != 0) {
    draco::GeometryMetadata metadata;
    if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata)) {
      return tl::unexpected<std::string>("has damaged metadata");
    }
  }
  Counts counts;
  bool read = false;
  if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING) {
    read = draco::DecodeVarint(&counts.triangles, &buffer) && draco::DecodeVarint(&counts.points, &buffer);
  } else if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
    uint8_t traversal = 0;
    uint32_t corners = 0;  // connectivity's vertices, before they are split
    read = buffer.Decode(&traversal) && draco::DecodeVarint(&corners, &buffer) &&
           draco::DecodeVarint(&counts.triangles, &buffer);
  }
  if (!read) return tl::unexpected<std::string>("has a damaged header");
  return counts;
}

// triangles against the index accessor: a strip of n indices has 1 to n - 2.
Result<void> checkTriangles(const Document& doc, const tinygltf::Primitive& primitive, uint64_t triangles,
                            const std::string& place) {
  const uint64_t indices = accessorAt(doc, primitive.indices).count;
  const bool strip = primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP;
  if (strip ? triangles > 0 && triangles + 2 <= indices : triangles * 3 == indices) return {};
  return doc.error(place,
                   "its data has " + std::to_string(triangles) + " triangles, but the accessor of the indices has " +
                       std::to_string(indices) + " elements",
                   dracoRemedy);
}

Result<void> checkPoints(const Document& doc, const tinygltf::Primitive& primitive, uint64_t points,
                         const std::string& place) {
  const uint64_t vertices = accessorAt(doc, primitive.attributes.at("POSITION")).count;
  if (points == vertices) return {};
  return doc.error(place,
                   "its data has " + std::to_string(points) + " vertices, but the accessors have " +
                       std::to_string(vertices) + " elements",
                   dracoRemedy);
}

Result<void> checkCounts(const Document& doc, const tinygltf::Primitive& primitive, std::span<const uint8_t> bytes,
                         const std::string& place) {
  const auto counts = readCounts(bytes);
  if (!counts) return doc.error(place, "its data " + counts.error(), dracoRemedy);
  if (auto ok = checkTriangles(doc, primitive, counts->triangles, place); !ok) return ok;
  if (counts->points != 0) {
    if (auto ok = checkPoints(doc, primitive, counts->points, place); !ok) return ok;
  }
  if (counts->triangles / largestTrianglesPerByte > bytes.size()) {
    return doc.error(
        place,
        std::to_string(bytes.size()) + " bytes are too few for " + std::to_string(counts->triangles) + " triangles",
        dracoRemedy);
  }
  return {};
}

// ---- Attributes -----------------------------------------------------------------------------------------------------

draco::DataType dracoType(int componentType) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return draco::DT_INT8;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return draco::DT_UINT8;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return draco::DT_INT16;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return draco::DT_UINT16;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return draco::DT_UINT32;
    default:
      return draco::DT_FLOAT32;
  }
}

// Whether every point's value lies inside the attribute's own data; Draco's readers do not look.
bool valuesExist(const draco::PointAttribute& attribute, uint32_t points) {
  if (attribute.buffer() == nullptr) return false;
  const auto component = static_cast<size_t>(draco::DataTypeLength(attribute.data_type()));
  const size_t size = component * static_cast<size_t>(attribute.num_components());
  const auto stride = static_cast<size_t>(attribute.byte_stride());
  if (stride < size || attribute.byte_offset() < 0) return false;
  const size_t have = attribute.buffer()->data_size();
  const auto offset = static_cast<size_t>(attribute.byte_offset());
  if (have < offset || attribute.size() > (have - offset) / std::max<size_t>(stride, 1)) return false;
  if (attribute.is_mapping_identity()) return points <= attribute.size();
  if (attribute.indices_map_size() < points) return false;
  for (uint32_t i = 0; i < points; ++i) {
    if (attribute.mapped_index(draco::PointIndex(i)).value() >= attribute.size()) return false;
  }
  return true;
}

// Bytes of one element after the other. False where a number does not fit the accessor's type.
bool copyValues(const draco::PointAttribute& attribute, uint32_t points, int componentType, uint8_t* out) {
  const auto size = static_cast<size_t>(attribute.num_components());
  if (attribute.data_type() == dracoType(componentType)) {
    const size_t bytes = size * static_cast<size_t>(draco::DataTypeLength(attribute.data_type()));
    for (uint32_t i = 0; i < points; ++i, out += bytes) {
      std::memcpy(out, attribute.GetAddress(attribute.mapped_index(draco::PointIndex(i))), bytes);
    }
    return true;
  }
  const auto convert = [&]<class T>(T) {
    std::vector<T> value(size);
    for (uint32_t i = 0; i < points; ++i, out += size * sizeof(T)) {
      const auto index = attribute.mapped_index(draco::PointIndex(i));
      if (!attribute.ConvertValue<T>(index, static_cast<int8_t>(size), value.data())) return false;
      std::memcpy(out, value.data(), size * sizeof(T));
    }
    return true;
  };
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return convert(int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return convert(uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return convert(int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return convert(uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return convert(uint32_t{});
    default:
      return convert(float{});
  }
}

Result<std::vector<uint8_t>> readAttribute(const Document& doc, const draco::Mesh& mesh, int id, int accessor,
                                           const std::string& place) {
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(static_cast<uint32_t>(id));
  if (attribute == nullptr) {
    return doc.error(place, "its data has no attribute with the identifier " + std::to_string(id), dracoRemedy);
  }
  const auto& a = accessorAt(doc, accessor);
  const int components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type));
  if (attribute->num_components() != components) {
    return doc.error(place,
                     "its data has " + std::to_string(static_cast<int>(attribute->num_components())) +
                         " components, but the accessor has " + std::to_string(components),
                     dracoRemedy);
  }
  if (attribute->data_type() == draco::DT_BOOL)  // whose bytes may hold anything
    return doc.error(place, "its data are truth values, which glTF has none of", dracoRemedy);
  if (!valuesExist(*attribute, mesh.num_points())) return doc.error(place, "its data is damaged", dracoRemedy);
  std::vector<uint8_t> bytes(mesh.num_points() * elementSize(a.componentType, a.type));
  if (!copyValues(*attribute, mesh.num_points(), a.componentType, bytes.data())) {
    return doc.error(place, "its data does not fit the accessor's component type", dracoRemedy);
  }
  return bytes;
}

}  // namespace

bool isDraco(const tinygltf::Primitive& primitive) { return primitive.extensions.count(dracoExtension) > 0; }

Result<void> checkDraco(const Document& doc, const tinygltf::Primitive& primitive, const std::string& place) {
  const Value& extension = primitive.extensions.at(dracoExtension);
  const std::string at = placeOf(place);
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES && primitive.mode != TINYGLTF_MODE_TRIANGLE_STRIP) {
    return doc.error(at, "is for triangles and triangle strips only", dracoRemedy);
  }
  if (primitive.indices == -1) return doc.error(place, "has Draco data, but no accessor for indices", dracoRemedy);
  const Value &view = memberValue(extension, "bufferView"), &attributes = memberValue(extension, "attributes");
  if (!view.IsInt()) return doc.error(at + "/bufferView", "is not a whole number", dracoRemedy);
  if (auto ok = checkIndex(doc, view.GetNumberAsInt(), doc.gltf.bufferViews.size(), at + "/bufferView", "buffer view");
      !ok) {
    return ok;
  }
  if (!attributes.IsObject()) return doc.error(at + "/attributes", "is not an object", dracoRemedy);
  for (const std::string& name : attributes.Keys()) {
    const Value& id = memberValue(attributes, name);
    if (!id.IsInt() || id.GetNumberAsInt() < 0) {
      return doc.error(at + "/attributes/" + name, "is not a whole number from 0 on", dracoRemedy);
    }
    if (primitive.attributes.count(name) == 0) {
      return doc.error(at + "/attributes/" + name, "is no attribute of the primitive", dracoRemedy);
    }
  }
  return {};
}

Result<DracoGeometry> decodeDraco(const Document& doc, const tinygltf::Primitive& primitive, const std::string& place,
                                  std::span<const char* const> wanted) {
  const std::string at = placeOf(place);
  const Value& extension = primitive.extensions.at(dracoExtension);
  const auto bytes = viewBytes(doc, extension.Get("bufferView").GetNumberAsInt());
  if (auto ok = checkCounts(doc, primitive, bytes, at); !ok) return tl::unexpected(ok.error());
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok()) {
    const std::string reason = decoded.status().error_msg_string();
    return doc.error(at, "its data is damaged or too short" + (reason.empty() ? "" : " (" + reason + ")"), dracoRemedy);
  }
  const std::unique_ptr<draco::Mesh> mesh = std::move(decoded).value();
  if (auto ok = checkTriangles(doc, primitive, mesh->num_faces(), at); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkPoints(doc, primitive, mesh->num_points(), at); !ok) return tl::unexpected(ok.error());

  DracoGeometry geometry;
  geometry.indices.reserve(mesh->num_faces() * size_t{3});
  for (uint32_t f = 0; f < mesh->num_faces(); ++f) {
    for (const draco::PointIndex& corner : mesh->face(draco::FaceIndex(f))) geometry.indices.push_back(corner.value());
  }
  const Value& attributes = extension.Get("attributes");
  for (const char* name : wanted) {
    if (!attributes.Has(name)) continue;
    const int id = attributes.Get(name).GetNumberAsInt();
    auto values = readAttribute(doc, *mesh, id, primitive.attributes.at(name), at + "/attributes/" + name);
    if (!values) return tl::unexpected(values.error());
    geometry.attributes.emplace(name, std::move(*values));
  }
  return geometry;
}

Elements decodedElements(const Document& doc, int accessor, std::span<const uint8_t> bytes) {
  const auto& a = accessorAt(doc, accessor);
  return {bytes.data(),
          a.count,
          elementSize(a.componentType, a.type),
          a.componentType,
          tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type)),
          a.normalized};
}

std::vector<bool> accessorsOfDraco(const Document& doc) {
  std::vector<bool> used(doc.gltf.accessors.size());
  const auto mark = [&](int accessor) {
    if (accessor >= 0 && static_cast<size_t>(accessor) < used.size()) used[static_cast<size_t>(accessor)] = true;
  };
  for (const auto& mesh : doc.gltf.meshes) {
    for (const auto& primitive : mesh.primitives) {
      if (!isDraco(primitive)) continue;
      mark(primitive.indices);
      for (const auto& [name, accessor] : primitive.attributes) mark(accessor);
    }
  }
  return used;
}

}  // namespace facet::io
