// A .gltf with what it names as one GLB, or with everything inside its text; a GLB as a .gltf.  Role: files
// that must travel alone, and those that must be readable.
#pragma once

#include "hgp/io/document.h"

namespace hgp::io {

/// The .gltf in `files` as a GLB: buffers one behind the other in its binary chunk, images in views of
/// their own. Fails like reading does where a side file is missing, and with kLimit beyond limits.maxBytes.
Result<Bytes> gltfAsGlb(const FileSet& files, const Limits& limits,
                        std::vector<std::string>& notes);

/// The .gltf text with buffers and images as data URIs. Images that cannot be read stay as they are named, and are
/// noted, here and in gltfAsGlb().
Result<Bytes> gltfWithEmbedded(ByteView text, const Resolver& resolve, const Limits& limits,
                               std::vector<std::string>& notes);

/// A GLB as the text `name` and a side file beside it with its binary chunk, byte for byte; views of the
/// chunk stay as they are, images in it as well. The side file is never named as one that the GLB needs.
/// Notes say which other chunks a .gltf cannot hold.
Result<Written> glbAsGltf(ByteView glb, const std::string& name);

/// Names of the side files of a .gltf or GLB: buffers and images that are no data URIs, once each, in order.
/// @param refused  gets why others may not be read (relativeName); what a scheme and host name is fetched by viewers
std::vector<std::string> gltfSideFiles(ByteView file, std::vector<std::string>* refused = nullptr);

}  // namespace hgp::io
