// OpenGL's functions, loaded by name: no library is linked, so that either OSMesa or EGL can bring
// them at run time. (Epoxy aborts with OSMesa; GL/osmesa.h would pull prototypes that clash.)
#pragma once

#include <GL/glcorearb.h>

namespace plait {

// Every function in use: X(type's part of the name, name).
#define PLAIT_GL_FUNCTIONS(X)                                         \
    X(ACTIVETEXTURE, ActiveTexture)                                   \
    X(ATTACHSHADER, AttachShader)                                     \
    X(BINDBUFFER, BindBuffer)                                         \
    X(BINDFRAMEBUFFER, BindFramebuffer)                               \
    X(BINDRENDERBUFFER, BindRenderbuffer)                             \
    X(BINDTEXTURE, BindTexture)                                       \
    X(BINDVERTEXARRAY, BindVertexArray)                               \
    X(BLENDFUNC, BlendFunc)                                           \
    X(BLITFRAMEBUFFER, BlitFramebuffer)                               \
    X(BUFFERDATA, BufferData)                                         \
    X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)                 \
    X(CLEAR, Clear)                                                   \
    X(CLEARCOLOR, ClearColor)                                         \
    X(COMPILESHADER, CompileShader)                                   \
    X(CREATEPROGRAM, CreateProgram)                                   \
    X(CREATESHADER, CreateShader)                                     \
    X(DELETEBUFFERS, DeleteBuffers)                                   \
    X(DELETEFRAMEBUFFERS, DeleteFramebuffers)                         \
    X(DELETEPROGRAM, DeleteProgram)                                   \
    X(DELETERENDERBUFFERS, DeleteRenderbuffers)                       \
    X(DELETESHADER, DeleteShader)                                     \
    X(DELETETEXTURES, DeleteTextures)                                 \
    X(DELETEVERTEXARRAYS, DeleteVertexArrays)                         \
    X(DEPTHFUNC, DepthFunc)                                           \
    X(DEPTHMASK, DepthMask)                                           \
    X(DISABLE, Disable)                                               \
    X(DRAWARRAYS, DrawArrays)                                         \
    X(DRAWELEMENTS, DrawElements)                                     \
    X(ENABLE, Enable)                                                 \
    X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray)               \
    X(FRONTFACE, FrontFace)                                           \
    X(FRAMEBUFFERRENDERBUFFER, FramebufferRenderbuffer)               \
    X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)                     \
    X(GENBUFFERS, GenBuffers)                                         \
    X(GENERATEMIPMAP, GenerateMipmap)                                 \
    X(GENFRAMEBUFFERS, GenFramebuffers)                               \
    X(GENRENDERBUFFERS, GenRenderbuffers)                             \
    X(GENTEXTURES, GenTextures)                                       \
    X(GENVERTEXARRAYS, GenVertexArrays)                               \
    X(GETERROR, GetError)                                             \
    X(GETINTEGERV, GetIntegerv)                                       \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)                           \
    X(GETPROGRAMIV, GetProgramiv)                                     \
    X(GETSHADERINFOLOG, GetShaderInfoLog)                             \
    X(GETSHADERIV, GetShaderiv)                                       \
    X(GETSTRING, GetString)                                           \
    X(GETUNIFORMLOCATION, GetUniformLocation)                         \
    X(LINKPROGRAM, LinkProgram)                                       \
    X(PIXELSTOREI, PixelStorei)                                       \
    X(READPIXELS, ReadPixels)                                         \
    X(RENDERBUFFERSTORAGEMULTISAMPLE, RenderbufferStorageMultisample) \
    X(SCISSOR, Scissor)                                               \
    X(SHADERSOURCE, ShaderSource)                                     \
    X(TEXIMAGE2D, TexImage2D)                                         \
    X(TEXPARAMETERI, TexParameteri)                                   \
    X(UNIFORM1F, Uniform1f)                                           \
    X(UNIFORM1I, Uniform1i)                                           \
    X(UNIFORM2F, Uniform2f)                                           \
    X(UNIFORM3F, Uniform3f)                                           \
    X(UNIFORM4F, Uniform4f)                                           \
    X(UNIFORMMATRIX4FV, UniformMatrix4fv)                             \
    X(USEPROGRAM, UseProgram)                                         \
    X(VERTEXATTRIBPOINTER, VertexAttribPointer)                       \
    X(VIEWPORT, Viewport)

#define PLAIT_DECLARE(TYPE, name) inline PFNGL##TYPE##PROC gl##name = nullptr;
PLAIT_GL_FUNCTIONS(PLAIT_DECLARE)
#undef PLAIT_DECLARE

// Fetches all of them through `find`. Throws std::runtime_error that names one that is missing.
void loadFunctions(void (*(*find)(const char* name))());

}  // namespace plait
