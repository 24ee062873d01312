//! The words that WGSL, GLSL, HLSL and MSL keep for themselves.
//!
//! Source: the lists of naga 30.0.2 (`keywords/wgsl.rs` and `back/*/keywords.rs`, which name the sections of each
//! specification): the WGSL candidate recommendation of 2025-08-09 (with its predeclared aliases, which naga leaves
//! out); GLSL 4.60 and ES 3.20 with Vulkan's additions; HLSL of FXC and DXC; C++14 and the Metal shading language.
//! Words that no name may look like anyway (a digit last, two underscores in a row, an underscore first) are left out.
//! A test of `spirv-tests` reads naga's lists again and compares.

/// What one language keeps, separated by white space, in ASCII order.
pub(crate) struct Vocabulary {
    /// The language's name.
    pub(crate) language: &'static str,
    /// Keywords, words reserved for later and predeclared types: no declaration may bear them.
    pub(crate) words: &'static str,
    /// Predeclared functions and values: a parameter or local may hide them, a declaration at module scope may not
    /// everywhere.
    pub(crate) functions: &'static str,
}

/// HLSL words that FXC takes in any letter case.
const ANY_CASE: [&str; 4] = ["asm", "decl", "pass", "technique"];

/// The language that reserves a word or predeclares a function of that name: the first of WGSL, GLSL, HLSL, MSL.
pub(crate) fn language(word: &str) -> Option<&'static str> {
    let keeps = |list: &str| list.split_ascii_whitespace().any(|kept| kept == word);
    if let Some(found) = LANGUAGES.iter().find(|found| keeps(found.words) || keeps(found.functions)) {
        return Some(found.language);
    }
    ANY_CASE.iter().any(|kept| kept.eq_ignore_ascii_case(word)).then_some("HLSL")
}

/// The four languages.
pub(crate) const LANGUAGES: [Vocabulary; 4] = [
    Vocabulary {
        language: "WGSL",
        words: "
    NULL Self abstract active alias alignas alignof array as asm asm_fragment async atomic attribute auto await become
    bool break case cast catch class co_await co_return co_yield coherent column_major common compile compile_fragment
    concept const const_assert const_cast consteval constexpr constinit continue continuing crate debugger decltype
    default delete demote demote_to_helper diagnostic discard do dynamic_cast else enable enum explicit export extends
    extern external fallthrough false filter final finally fn for friend from fxgroup get goto groupshared highp if
    impl implements import inline instanceof interface layout let loop lowp macro macro_rules mat2x2f mat2x2h mat2x3f
    mat2x3h mat2x4f mat2x4h mat3x2f mat3x2h mat3x3f mat3x3h mat3x4f mat3x4h mat4x2f mat4x2h mat4x3f mat4x3h mat4x4f
    mat4x4h match mediump meta mod module move mut mutable namespace new nil noexcept noinline nointerpolation
    non_coherent noncoherent noperspective null nullptr of operator override package packoffset partition pass patch
    pixelfragment precise precision premerge priv protected ptr pub public readonly ref regardless register
    reinterpret_cast require requires resource restrict return sampler sampler_comparison self set shared sizeof
    smooth snorm static static_assert static_cast std struct subroutine super switch target template texture_1d
    texture_2d texture_2d_array texture_3d texture_cube texture_cube_array texture_depth_2d texture_depth_2d_array
    texture_depth_cube texture_depth_cube_array texture_depth_multisampled_2d texture_external texture_multisampled_2d
    texture_storage_1d texture_storage_2d texture_storage_2d_array texture_storage_3d this thread_local throw trait
    true try type typedef typeid typename typeof union unless unorm unsafe unsized use using var varying vec2f vec2h
    vec2i vec2u vec3f vec3h vec3i vec3u vec4f vec4h vec4i vec4u virtual volatile wgsl where while with writeonly yield",
        functions: "
    abs acos acosh all any arrayLength asin asinh atan atanh atomicAdd atomicAnd atomicCompareExchangeWeak
    atomicExchange atomicLoad atomicMax atomicMin atomicOr atomicStore atomicSub atomicXor bgra8unorm bitcast ceil
    clamp cos cosh countLeadingZeros countOneBits countTrailingZeros cross degrees determinant distance dot
    dot4I8Packed dot4U8Packed dpdx dpdxCoarse dpdxFine dpdy dpdyCoarse dpdyFine exp extractBits faceForward
    firstLeadingBit firstTrailingBit floor fma fract frexp function fwidth fwidthCoarse fwidthFine insertBits
    inverseSqrt ldexp length log max min mix modf normalize pack2x16float pack2x16snorm pack2x16unorm pack4x8snorm
    pack4x8unorm pack4xI8Clamp pack4xU8Clamp pow private push_constant quadBroadcast quadSwapDiagonal quadSwapX
    quadSwapY r16float r16sint r16snorm r16uint r16unorm r32float r32sint r32uint r64uint r8sint r8snorm r8uint
    r8unorm radians read read_write reflect refract reverseBits rg11b10ufloat rg16float rg16sint rg16snorm rg16uint
    rg16unorm rg32float rg32sint rg32uint rg8sint rg8snorm rg8uint rg8unorm rgb10a2uint rgb10a2unorm rgba16float
    rgba16sint rgba16snorm rgba16uint rgba16unorm rgba32float rgba32sint rgba32uint rgba8sint rgba8snorm rgba8uint
    rgba8unorm round saturate select sign sin sinh smoothstep sqrt step storage storageBarrier subgroupAdd subgroupAll
    subgroupAnd subgroupAny subgroupBallot subgroupBroadcast subgroupBroadcastFirst subgroupElect subgroupExclusiveAdd
    subgroupExclusiveMul subgroupInclusiveAdd subgroupInclusiveMul subgroupMax subgroupMin subgroupMul subgroupOr
    subgroupShuffle subgroupShuffleDown subgroupShuffleUp subgroupShuffleXor subgroupXor tan tanh textureBarrier
    textureDimensions textureGather textureGatherCompare textureLoad textureNumLayers textureNumLevels
    textureNumSamples textureSample textureSampleBaseClampToEdge textureSampleBias textureSampleCompare
    textureSampleCompareLevel textureSampleGrad textureSampleLevel textureStore transpose trunc uniform
    unpack2x16float unpack2x16snorm unpack2x16unorm unpack4x8snorm unpack4x8unorm workgroup workgroupBarrier
    workgroupUniformLoad write",
    },
    Vocabulary {
        language: "GLSL",
        words: "
    active asm atomic_uint attribute bool break buffer case cast centroid class coherent common const continue default
    discard do double else enum extern external false filter fixed flat float for goto half highp if iimage1D
    iimage1DArray iimage2D iimage2DArray iimage2DMS iimage2DMSArray iimage2DRect iimage3D iimageBuffer iimageCube
    iimageCubeArray image1D image1DArray image1DArrayShadow image1DShadow image2D image2DArray image2DArrayShadow
    image2DMS image2DMSArray image2DRect image2DShadow image3D imageBuffer imageCube imageCubeArray in inline inout
    input int interface invariant isampler1D isampler1DArray isampler2D isampler2DArray isampler2DMS isampler2DMSArray
    isampler2DRect isampler3D isamplerBuffer isamplerCube isamplerCubeArray isubpassInput isubpassInputMS itexture1D
    itexture1DArray itexture2D itexture2DArray itexture2DMS itexture2DMSArray itexture2DRect itexture3D itextureBuffer
    itextureCube itextureCubeArray layout long lowp main mediump namespace noinline noperspective out output packed
    partition patch precise precision public readonly resource restrict return row_major sample sampler sampler1D
    sampler1DArray sampler1DArrayShadow sampler1DShadow sampler2D sampler2DArray sampler2DArrayShadow sampler2DMS
    sampler2DMSArray sampler2DRect sampler2DRectShadow sampler2DShadow sampler3D sampler3DRect samplerBuffer
    samplerCube samplerCubeArray samplerCubeArrayShadow samplerCubeShadow samplerShadow shared short sizeof smooth
    static struct subpassInput subpassInputMS subroutine superp switch template texture1D texture1DArray texture2D
    texture2DArray texture2DMS texture2DMSArray texture2DRect texture3D textureBuffer textureCube textureCubeArray
    this true typedef uimage1D uimage1DArray uimage2D uimage2DArray uimage2DMS uimage2DMSArray uimage2DRect uimage3D
    uimageBuffer uimageCube uimageCubeArray uint uniform union unsigned usampler1D usampler1DArray usampler2D
    usampler2DArray usampler2DMS usampler2DMSArray usampler2DRect usampler3D usamplerBuffer usamplerCube
    usamplerCubeArray using usubpassInput usubpassInputMS utexture1D utexture1DArray utexture2D utexture2DArray
    utexture2DMS utexture2DMSArray utexture2DRect utexture3D utextureBuffer utextureCube utextureCubeArray varying
    void volatile while writeonly",
        functions: "
    EmitStreamVertex EmitVertex EndPrimitive EndStreamPrimitive abs acos acosh all allInvocations allInvocationsEqual
    any anyInvocation asin asinh atan atanh atomicAdd atomicAnd atomicCompSwap atomicCounter atomicCounterAdd
    atomicCounterAnd atomicCounterCompSwap atomicCounterDecrement atomicCounterExchange atomicCounterIncrement
    atomicCounterMax atomicCounterMin atomicCounterOr atomicCounterSubtract atomicCounterXor atomicExchange atomicMax
    atomicMin atomicOr atomicXor barrier bitCount bitfieldExtract bitfieldInsert bitfieldReverse ceil clamp cos cosh
    cross dFdx dFdxCoarse dFdxFine dFdy dFdyCoarse dFdyFine degrees determinant distance dot equal exp faceforward
    findLSB findMSB floatBitsToInt floatBitsToUint floor fma fract frexp ftransform fwidth fwidthCoarse fwidthFine
    greaterThan greaterThanEqual groupMemoryBarrier imageAtomicAdd imageAtomicAnd imageAtomicCompSwap
    imageAtomicExchange imageAtomicMax imageAtomicMin imageAtomicOr imageAtomicXor imageLoad imageSamples imageSize
    imageStore imulExtended intBitsToFloat interpolateAtCentroid interpolateAtOffset interpolateAtSample inverse
    inversesqrt isinf isnan ldexp length lessThan lessThanEqual log matrixCompMult max memoryBarrier
    memoryBarrierAtomicCounter memoryBarrierBuffer memoryBarrierImage memoryBarrierShared min mix mod modf normalize
    not notEqual outerProduct pow radians reflect refract round roundEven shadow1D shadow1DLod shadow1DProj
    shadow1DProjLod shadow2D shadow2DLod shadow2DProj shadow2DProjLod sign sin sinh smoothstep sqrt step subpassLoad
    tan tanh texelFetch texelFetchOffset texture texture1DLod texture1DProj texture1DProjLod texture2DLod
    texture2DProj texture2DProjLod texture3DLod texture3DProj texture3DProjLod textureCubeLod textureGather
    textureGatherOffset textureGatherOffsets textureGrad textureGradOffset textureLod textureLodOffset textureOffset
    textureProj textureProjGrad textureProjGradOffset textureProjLod textureProjLodOffset textureProjOffset
    textureQueryLevels textureQueryLod textureSamples textureSize transpose trunc uaddCarry uintBitsToFloat
    umulExtended usubBorrow",
    },
    Vocabulary {
        language: "HLSL",
        words: "
    AppendStructuredBuffer BlendState Buffer ByteAddressBuffer CompileShader ComputeShader ConstantBuffer
    ConsumeStructuredBuffer DepthStencilState DepthStencilView DomainShader FeedbackTexture2D FeedbackTexture2DArray
    GeometryShader Hullshader InputPatch LineStream NULL OutputPatch PixelShader PointStream RWBuffer
    RWByteAddressBuffer RWStructuredBuffer RWTexture1D RWTexture1DArray RWTexture2D RWTexture2DArray RWTexture2DMS
    RWTexture2DMSArray RWTexture3D RWTextureCube RWTextureCubeArray RasterizerOrderedBuffer
    RasterizerOrderedByteAddressBuffer RasterizerOrderedStructuredBuffer RasterizerOrderedTexture1D
    RasterizerOrderedTexture1DArray RasterizerOrderedTexture2D RasterizerOrderedTexture2DArray
    RasterizerOrderedTexture3D RasterizerState RayDesc RayQuery RaytracingAccelerationStructure RenderTargetView
    SamplerComparisonState SamplerState StructuredBuffer Technique Texture1D Texture1DArray Texture2D Texture2DArray
    Texture2DMS Texture2DMSArray Texture3D TextureBuffer TextureCube TextureCubeArray TriangleStream VertexShader asm
    asm_fragment auto bool break case catch cbuffer center centroid char class column_major compile compile_fragment
    const const_cast continue decl default delete discard do double dword dynamic_cast else enum explicit export
    extern false float float16_t float32_t float64_t for friend fxgroup globallycoherent goto groupshared half if in
    indices inline inout int int16_t int32_t int64_t int8_t4_packed interface line lineadj linear long matrix
    min10float min12int min16float min16int min16uint mutable namespace new nointerpolation noperspective operator out
    packoffset pass payload pixelfragment point precise primitives private protected public register reinterpret_cast
    return row_major sample sampler sampler_state shared short signed sizeof snorm stateblock stateblock_state static
    static_cast string struct switch tbuffer technique template texture this throw triangle triangleadj true try
    typedef typeid typename uint uint16_t uint32_t uint64_t uint8_t4_packed uniform union unorm unsigned using vector
    vertexfragment vertices virtual void volatile wchar_t while",
        functions: "
    AcceptHitAndEndSearch AllMemoryBarrier AllMemoryBarrierWithGroupSync AllocateRayQuery CallShader
    CheckAccessFullyMapped CreateResourceFromHeap DeviceMemoryBarrier DeviceMemoryBarrierWithGroupSync DispatchMesh
    DispatchRaysDimensions DispatchRaysIndex EvaluateAttributeAtSample EvaluateAttributeCentroid
    EvaluateAttributeSnapped GeometryIndex GetAttributeAtVertex GetRenderTargetSampleCount
    GetRenderTargetSamplePosition GroupMemoryBarrier GroupMemoryBarrierWithGroupSync HitKind IgnoreHit InstanceID
    InstanceIndex InterlockedAdd InterlockedAnd InterlockedCompareExchange InterlockedCompareExchangeFloatBitwise
    InterlockedCompareStore InterlockedCompareStoreFloatBitwise InterlockedExchange InterlockedMax InterlockedMin
    InterlockedOr InterlockedXor IsHelperLane NonUniformResourceIndex ObjectRayDirection ObjectRayOrigin ObjectToWorld
    PrimitiveIndex Process2DQuadTessFactorsAvg Process2DQuadTessFactorsMax Process2DQuadTessFactorsMin
    ProcessIsolineTessFactors ProcessQuadTessFactorsAvg ProcessQuadTessFactorsMax ProcessQuadTessFactorsMin
    ProcessTriTessFactorsAvg ProcessTriTessFactorsMax ProcessTriTessFactorsMin QuadAll QuadAny QuadReadAcrossDiagonal
    QuadReadAcrossX QuadReadAcrossY QuadReadLaneAt RayFlags RayTCurrent RayTMin ReportHit SetMeshOutputCounts TraceRay
    WaveActiveAllEqual WaveActiveAllTrue WaveActiveAnyTrue WaveActiveBallot WaveActiveBitAnd WaveActiveBitOr
    WaveActiveBitXor WaveActiveCountBits WaveActiveMax WaveActiveMin WaveActiveProduct WaveActiveSum WaveGetLaneCount
    WaveGetLaneIndex WaveIsFirstLane WaveMatch WaveMultiPrefixBitAnd WaveMultiPrefixBitOr WaveMultiPrefixBitXor
    WaveMultiPrefixCountBits WaveMultiPrefixProduct WaveMultiPrefixSum WavePrefixCountBits WavePrefixProduct
    WavePrefixSum WaveReadLaneAt WaveReadLaneFirst WorldRayDirection WorldRayOrigin WorldToObject abort abs acos all
    and any asdouble asfloat asin asint asuint atan ceil clamp clip cos cosh countbits cross ddx ddx_coarse ddx_fine
    ddy ddy_coarse ddy_fine degrees determinant distance dot dot2add dot4add_i8packed dot4add_u8packed dst errorf exp
    faceforward firstbithigh firstbitlow floor fma fmod frac frexp fwidth isfinite isinf isnan ldexp length lerp lit
    log mad max min modf mul noise normalize or pow printf radians rcp reflect refract reversebits round rsqrt
    saturate select sign sin sincos sinh smoothstep source_mark sqrt step tan tanh tex1D tex1Dbias tex1Dgrad tex1Dlod
    tex1Dproj tex2D tex2Dbias tex2Dgrad tex2Dlod tex2Dproj tex3D tex3Dbias tex3Dgrad tex3Dlod tex3Dproj texCUBE
    texCUBEbias texCUBEgrad texCUBElod texCUBEproj transpose trunc",
    },
    Vocabulary {
        language: "MSL",
        words: "
    CHAR_BIT CHAR_MAX CHAR_MIN DBL_DECIMAL_DIG DBL_DIG DBL_EPSILON DBL_MANT_DIG DBL_MAX DBL_MAX_10_EXP DBL_MAX_EXP
    DBL_MIN DBL_MIN_10_EXP DBL_MIN_EXP DBL_RADIX DefaultConstructible FLT_DECIMAL_DIG FLT_DIG FLT_EPSILON FLT_MANT_DIG
    FLT_MAX FLT_MAX_10_EXP FLT_MAX_EXP FLT_MIN FLT_MIN_10_EXP FLT_MIN_EXP FLT_RADIX FP_ILOGBNAN HALF_DECIMAL_DIG
    HALF_DIG HALF_EPSILON HALF_MANT_DIG HALF_MAX HALF_MAX_10_EXP HALF_MAX_EXP HALF_MIN HALF_MIN_10_EXP HALF_MIN_EXP
    HALF_RADIX HUGE_VAL HUGE_VALF HUGE_VALH INFINITY INT_MAX INT_MIN LLONG_MAX LLONG_MIN LONG_MAX LONG_MIN MAXDOUBLE
    MAXFLOAT MAXHALF M_1_PI M_1_PI_F M_1_PI_H M_2_PI M_2_PI_F M_2_PI_H M_2_SQRTPI M_2_SQRTPI_F M_2_SQRTPI_H M_E M_E_F
    M_E_H M_LN10_F M_LN10_H M_LN2_F M_LN2_H M_LOG10E M_LOG10E_F M_LOG10E_H M_LOG2E M_LOG2E_F M_LOG2E_H M_PI M_PI_2_F
    M_PI_2_H M_PI_4_F M_PI_4_H M_PI_F M_PI_H M_SQRT1_2_F M_SQRT1_2_H M_SQRT2_F M_SQRT2_H NAN SCHAR_MAX SCHAR_MIN
    SHRT_MAX SHRT_MIN UCHAR_MAX UINT_MAX ULLONG_MAX ULONG_MAX USHRT_MAX alignas alignof and and_eq as_type asm assert
    atomic atomic_bool atomic_float atomic_int atomic_uint atomic_ulong auto bfloat bitand bitor bool break case catch
    char char16_t char32_t class compl complex const const_cast constant constexpr continue decltype default delete
    device do double dynamic_cast else enum explicit export extern false float for fragment friend goto half if
    imaginary inline int int16_t int32_t int64_t int8_t kernel llong long main matrix metal mutable namespace new
    noexcept not not_eq nullptr object_data operator or or_eq packed_vec private protected ptrdiff_t public quad
    ray_data register reinterpret_cast restrict return short signed size_t sizeof static static_assert static_cast
    struct switch template this thread thread_local threadgroup threadgroup_imageblock throw true try typedef typeid
    typename uchar uint uint16_t uint32_t uint64_t uint8_t ullong union unsigned ushort using vec vertex virtual void
    volatile wchar_t while xor xor_eq",
        functions: "",
    },
];
