// Conversions between the containers of glTF: a .gltf with its side files as one GLB or as one .gltf, a GLB as
// a .gltf.  Role: results that must be a single file, or text that people can read.
#pragma once

#include "hgp/io/document.h"

namespace hgp::io {

/// The .gltf in `files` as a GLB: its buffers are concatenated in the binary chunk, and images get views of
/// their own. Fails as reading does if a buffer's file is missing, and with kLimit beyond limits.maxBytes.
Result<Bytes> gltfAsGlb(const FileSet& files, const Limits& limits, Notes& notes);

/// The .gltf text with buffers and images as data URIs. An image that cannot be read keeps its URI, and a note
/// says so, here and in gltfAsGlb().
Result<Bytes> gltfWithEmbedded(ByteView text, const Resolver& resolve, const Limits& limits,
                               Notes& notes);

/// A GLB as the text file `name` and a side file with its binary chunk, byte for byte; views and embedded images
/// stay as they are. The side file's name differs from those of the files that the GLB refers to.
/// Notes list the other chunks, which a .gltf cannot contain.
Result<Written> glbAsGltf(ByteView glb, const std::string& name);

/// Names of the side files of a .gltf or GLB: buffers and images that are not data URIs, each once, in order.
/// @param refused  receives the reasons why others are not read (relativeName); absolute URLs, which viewers
///                 fetch themselves, are omitted
std::vector<std::string> gltfSideFiles(ByteView file, std::vector<std::string>* refused = nullptr);

}  // namespace hgp::io
