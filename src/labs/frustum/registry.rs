//! The methods of this lab. To add one: a file in `algo::cull`, its [`FrustumDemo`](super::method_info::FrustumDemo) here beside the
//! others, one line below.

use crate::algo::cull::{
    BackFace, BoxCull, Funnel, PointPlanes, SphereCull,
    faulty::{AroundOrigin, Clockwise, ConstantView, FaultyFunnel, OneAngle, TurnsSign},
};

use super::{MethodInfo, OnScene};

/// Every method, in the order in which they are taught; the mistakes last.
pub static METHODS: [MethodInfo; 10] = [
    MethodInfo::of::<OnScene<PointPlanes>>(),
    MethodInfo::of::<OnScene<SphereCull>>(),
    MethodInfo::of::<OnScene<BoxCull>>(),
    MethodInfo::of::<OnScene<BackFace>>(),
    MethodInfo::of::<OnScene<Funnel>>(),
    MethodInfo::of::<OnScene<FaultyFunnel<OneAngle>>>(),
    MethodInfo::of::<OnScene<FaultyFunnel<TurnsSign>>>(),
    MethodInfo::of::<OnScene<FaultyFunnel<AroundOrigin>>>(),
    MethodInfo::of::<OnScene<FaultyFunnel<Clockwise>>>(),
    MethodInfo::of::<OnScene<FaultyFunnel<ConstantView>>>(),
];
