/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */var Ra=0,oo=1,La=2;var ci=1,Na=2,yA=3,zn=0,be=1,hn=2,eA=0,SA=1,ao=2,co=3,lo=4,Ha=5;var nA=100,Oa=101,Ga=102,ka=103,za=104,Va=200,Ya=201,Ja=202,Wa=203,ho=204,uo=205,Ka=206,Xa=207,qa=208,Za=209,ja=210,$a=211,tc=212,ec=213,nc=214,ji=0,$i=1,ts=2,CA=3,es=4,ns=5,As=6,is=7,Ps=0,Ac=1,ic=2,un=0,fo=1,go=2,po=3,mo=4,Bo=5,wo=6,Co=7;var Eo=300,AA=301,QA=302,Fs=303,Us=304,ss=1e3,an=1001,rs=1002,me=1003,sc=1004;var li=1005;var Ie=1006,Rs=1007;var yn=1008;var Ue=1009,Mo=1010,vo=1011,IA=1012,Ls=1013,en=1014,nn=1015,An=1016,Ns=1017,Hs=1018,iA=1020,Do=35902,xo=35899,_o=1021,yo=1022,sn=1023,vn=1026,Sn=1027,So=1028,Os=1029,Vn=1030,Gs=1031;var ks=1033,hi=33776,ui=33777,fi=33778,di=33779,zs=35840,Vs=35841,Ys=35842,Js=35843,Ws=36196,Ks=37492,Xs=37496,qs=37488,Zs=37489,gi=37490,js=37491,$s=37808,tr=37809,er=37810,nr=37811,Ar=37812,ir=37813,sr=37814,rr=37815,or=37816,ar=37817,cr=37818,lr=37819,hr=37820,ur=37821,fr=36492,dr=36494,gr=36495,pr=36283,mr=36284,pi=36285,Br=36286;var GA=2300,os=2301,Xi=2302,to=2303,eo=2400,no=2401,Ao=2402;var rc=3200;var wr=0,oc=1,Qn="",Ce="srgb",kA="srgb-linear",zA="linear",Wt="srgb";var qi=7680;var ac=519,cc=512,lc=513,hc=514,Qo=515,uc=516,fc=517,Io=518,bo=519,dc=35044;var To="300 es",Xe=2e3,EA=2001;function ll(A){for(let t=A.length-1;t>=0;--t)if(A[t]>=65535)return!0;return!1}function hl(A){return ArrayBuffer.isView(A)&&!(A instanceof DataView)}function VA(A){return document.createElementNS("http://www.w3.org/1999/xhtml",A)}function gc(){let A=VA("canvas");return A.style.display="block",A}var ca={},MA=null;function Po(...A){let t="THREE."+A.shift();MA?MA("log",t,...A):console.log(t,...A)}function pc(A){let t=A[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=A[1];e&&e.isStackTrace?A[0]+=" "+e.getLocation():A[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return A}function yt(...A){A=pc(A);let t="THREE."+A.shift();if(MA)MA("warn",t,...A);else{let e=A[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...A)}}function Qt(...A){A=pc(A);let t="THREE."+A.shift();if(MA)MA("error",t,...A);else{let e=A[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...A)}}function OA(...A){let t=A.join(" ");t in ca||(ca[t]=!0,yt(...A))}function mc(A,t,e){return new Promise(function(n,i){function s(){switch(A.clientWaitSync(t,A.SYNC_FLUSH_COMMANDS_BIT,0)){case A.WAIT_FAILED:i();break;case A.TIMEOUT_EXPIRED:setTimeout(s,e);break;default:n()}}setTimeout(s,e)})}var Bc={[ji]:ji,[ts]:As,[es]:es,[CA]:ns,[$i]:$i,[As]:ts,[is]:is,[ns]:CA},cn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let i=n[t];if(i!==void 0){let s=i.indexOf(e);s!==-1&&i.splice(s,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let i=n.slice(0);for(let s=0,r=i.length;s<r;s++)i[s].call(this,t);t.target=null}}},xe=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"];var Zi=Math.PI/180,as=180/Math.PI;function mi(){let A=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(xe[A&255]+xe[A>>8&255]+xe[A>>16&255]+xe[A>>24&255]+"-"+xe[t&255]+xe[t>>8&255]+"-"+xe[t>>16&15|64]+xe[t>>24&255]+"-"+xe[e&63|128]+xe[e>>8&255]+"-"+xe[e>>16&255]+xe[e>>24&255]+xe[n&255]+xe[n>>8&255]+xe[n>>16&255]+xe[n>>24&255]).toLowerCase()}function zt(A,t,e){return Math.max(t,Math.min(e,A))}function ul(A,t){return(A%t+t)%t}function br(A,t,e){return(1-e)*A+e*t}function wc(A){return Math.pow(2,Math.floor(Math.log(A)/Math.LN2))}function Fo(A){switch(A.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function fl(A,t){if(t.constructor===Float32Array)return A;let e=Fo(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(A/e,-1)}function dl(A,t){if(t.constructor===Float32Array)return A;let e=Fo(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(A*e)}var Vt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,i=t.elements;return this.x=i[0]*e+i[3]*n+i[6],this.y=i[1]*e+i[4]*n+i[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=zt(this.x,t.x,e.x),this.y=zt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=zt(this.x,t,e),this.y=zt(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(zt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(zt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),i=Math.sin(e),s=this.x-t.x,r=this.y-t.y;return this.x=s*n-r*i+t.x,this.y=s*i+r*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Oe=class{constructor(t=0,e=0,n=0,i=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=i}static slerpFlat(t,e,n,i,s,r,o){let c=n[i+0],a=n[i+1],l=n[i+2],g=n[i+3],h=s[r+0],d=s[r+1],m=s[r+2],C=s[r+3];if(g!==C||c!==h||a!==d||l!==m){let f=c*h+a*d+l*m+g*C;f<0&&(h=-h,d=-d,m=-m,C=-C,f=-f);let u=1-o;if(f<.9995){let E=Math.acos(f),_=Math.sin(E);u=Math.sin(u*E)/_,o=Math.sin(o*E)/_,c=c*u+h*o,a=a*u+d*o,l=l*u+m*o,g=g*u+C*o}else{c=c*u+h*o,a=a*u+d*o,l=l*u+m*o,g=g*u+C*o;let E=1/Math.sqrt(c*c+a*a+l*l+g*g);c*=E,a*=E,l*=E,g*=E}}t[e]=c,t[e+1]=a,t[e+2]=l,t[e+3]=g}static multiplyQuaternionsFlat(t,e,n,i,s,r){let o=n[i],c=n[i+1],a=n[i+2],l=n[i+3],g=s[r],h=s[r+1],d=s[r+2],m=s[r+3];return t[e]=o*m+l*g+c*d-a*h,t[e+1]=c*m+l*h+a*g-o*d,t[e+2]=a*m+l*d+o*h-c*g,t[e+3]=l*m-o*g-c*h-a*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,i){return this._x=t,this._y=e,this._z=n,this._w=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,i=t._y,s=t._z,r=t._order,o=Math.cos,c=Math.sin,a=o(n/2),l=o(i/2),g=o(s/2),h=c(n/2),d=c(i/2),m=c(s/2);switch(r){case"XYZ":this._x=h*l*g+a*d*m,this._y=a*d*g-h*l*m,this._z=a*l*m+h*d*g,this._w=a*l*g-h*d*m;break;case"YXZ":this._x=h*l*g+a*d*m,this._y=a*d*g-h*l*m,this._z=a*l*m-h*d*g,this._w=a*l*g+h*d*m;break;case"ZXY":this._x=h*l*g-a*d*m,this._y=a*d*g+h*l*m,this._z=a*l*m+h*d*g,this._w=a*l*g-h*d*m;break;case"ZYX":this._x=h*l*g-a*d*m,this._y=a*d*g+h*l*m,this._z=a*l*m-h*d*g,this._w=a*l*g+h*d*m;break;case"YZX":this._x=h*l*g+a*d*m,this._y=a*d*g+h*l*m,this._z=a*l*m-h*d*g,this._w=a*l*g-h*d*m;break;case"XZY":this._x=h*l*g-a*d*m,this._y=a*d*g-h*l*m,this._z=a*l*m+h*d*g,this._w=a*l*g+h*d*m;break;default:yt("Quaternion: .setFromEuler() encountered an unknown order: "+r)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,i=Math.sin(n);return this._x=t.x*i,this._y=t.y*i,this._z=t.z*i,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],i=e[4],s=e[8],r=e[1],o=e[5],c=e[9],a=e[2],l=e[6],g=e[10],h=n+o+g;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(l-c)*d,this._y=(s-a)*d,this._z=(r-i)*d}else if(n>o&&n>g){let d=2*Math.sqrt(1+n-o-g);this._w=(l-c)/d,this._x=.25*d,this._y=(i+r)/d,this._z=(s+a)/d}else if(o>g){let d=2*Math.sqrt(1+o-n-g);this._w=(s-a)/d,this._x=(i+r)/d,this._y=.25*d,this._z=(c+l)/d}else{let d=2*Math.sqrt(1+g-n-o);this._w=(r-i)/d,this._x=(s+a)/d,this._y=(c+l)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(zt(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let i=Math.min(1,e/n);return this.slerp(t,i),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,i=t._y,s=t._z,r=t._w,o=e._x,c=e._y,a=e._z,l=e._w;return this._x=n*l+r*o+i*a-s*c,this._y=i*l+r*c+s*o-n*a,this._z=s*l+r*a+n*c-i*o,this._w=r*l-n*o-i*c-s*a,this._onChangeCallback(),this}slerp(t,e){let n=t._x,i=t._y,s=t._z,r=t._w,o=this.dot(t);o<0&&(n=-n,i=-i,s=-s,r=-r,o=-o);let c=1-e;if(o<.9995){let a=Math.acos(o),l=Math.sin(a);c=Math.sin(c*a)/l,e=Math.sin(e*a)/l,this._x=this._x*c+n*e,this._y=this._y*c+i*e,this._z=this._z*c+s*e,this._w=this._w*c+r*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+i*e,this._z=this._z*c+s*e,this._w=this._w*c+r*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),i=Math.sqrt(1-n),s=Math.sqrt(n);return this.set(i*Math.sin(t),i*Math.cos(t),s*Math.sin(e),s*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},R=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(la.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(la.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,i=this.z,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6]*i,this.y=s[1]*e+s[4]*n+s[7]*i,this.z=s[2]*e+s[5]*n+s[8]*i,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,i=this.z,s=t.elements,r=1/(s[3]*e+s[7]*n+s[11]*i+s[15]);return this.x=(s[0]*e+s[4]*n+s[8]*i+s[12])*r,this.y=(s[1]*e+s[5]*n+s[9]*i+s[13])*r,this.z=(s[2]*e+s[6]*n+s[10]*i+s[14])*r,this}applyQuaternion(t){let e=this.x,n=this.y,i=this.z,s=t.x,r=t.y,o=t.z,c=t.w,a=2*(r*i-o*n),l=2*(o*e-s*i),g=2*(s*n-r*e);return this.x=e+c*a+r*g-o*l,this.y=n+c*l+o*a-s*g,this.z=i+c*g+s*l-r*a,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,i=this.z,s=t.elements;return this.x=s[0]*e+s[4]*n+s[8]*i,this.y=s[1]*e+s[5]*n+s[9]*i,this.z=s[2]*e+s[6]*n+s[10]*i,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=zt(this.x,t.x,e.x),this.y=zt(this.y,t.y,e.y),this.z=zt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=zt(this.x,t,e),this.y=zt(this.y,t,e),this.z=zt(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(zt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,i=t.y,s=t.z,r=e.x,o=e.y,c=e.z;return this.x=i*c-s*o,this.y=s*r-n*c,this.z=n*o-i*r,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return Tr.copy(this).projectOnVector(t),this.sub(Tr)}reflect(t){return this.sub(Tr.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(zt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,i=this.z-t.z;return e*e+n*n+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let i=Math.sin(e)*t;return this.x=i*Math.sin(n),this.y=Math.cos(e)*t,this.z=i*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),i=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=i,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Tr=new R,la=new Oe,bt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,i,s,r,o,c,a){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,i,s,r,o,c,a)}set(t,e,n,i,s,r,o,c,a){let l=this.elements;return l[0]=t,l[1]=i,l[2]=o,l[3]=e,l[4]=s,l[5]=c,l[6]=n,l[7]=r,l[8]=a,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,i=e.elements,s=this.elements,r=n[0],o=n[3],c=n[6],a=n[1],l=n[4],g=n[7],h=n[2],d=n[5],m=n[8],C=i[0],f=i[3],u=i[6],E=i[1],_=i[4],D=i[7],S=i[2],x=i[5],p=i[8];return s[0]=r*C+o*E+c*S,s[3]=r*f+o*_+c*x,s[6]=r*u+o*D+c*p,s[1]=a*C+l*E+g*S,s[4]=a*f+l*_+g*x,s[7]=a*u+l*D+g*p,s[2]=h*C+d*E+m*S,s[5]=h*f+d*_+m*x,s[8]=h*u+d*D+m*p,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],i=t[2],s=t[3],r=t[4],o=t[5],c=t[6],a=t[7],l=t[8];return e*r*l-e*o*a-n*s*l+n*o*c+i*s*a-i*r*c}invert(){let t=this.elements,e=t[0],n=t[1],i=t[2],s=t[3],r=t[4],o=t[5],c=t[6],a=t[7],l=t[8],g=l*r-o*a,h=o*c-l*s,d=a*s-r*c,m=e*g+n*h+i*d;if(m===0)return this.set(0,0,0,0,0,0,0,0,0);let C=1/m;return t[0]=g*C,t[1]=(i*a-l*n)*C,t[2]=(o*n-i*r)*C,t[3]=h*C,t[4]=(l*e-i*c)*C,t[5]=(i*s-o*e)*C,t[6]=d*C,t[7]=(n*c-a*e)*C,t[8]=(r*e-n*s)*C,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,i,s,r,o){let c=Math.cos(s),a=Math.sin(s);return this.set(n*c,n*a,-n*(c*r+a*o)+r+t,-i*a,i*c,-i*(-a*r+c*o)+o+e,0,0,1),this}scale(t,e){return OA("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Pr.makeScale(t,e)),this}rotate(t){return OA("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Pr.makeRotation(-t)),this}translate(t,e){return OA("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Pr.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let i=0;i<9;i++)if(e[i]!==n[i])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Pr=new bt,ha=new bt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),ua=new bt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function gl(){let A={enabled:!0,workingColorSpace:kA,spaces:{},convert:function(i,s,r){return this.enabled===!1||s===r||!s||!r||(this.spaces[s].transfer===Wt&&(i.r=Mn(i.r),i.g=Mn(i.g),i.b=Mn(i.b)),this.spaces[s].primaries!==this.spaces[r].primaries&&(i.applyMatrix3(this.spaces[s].toXYZ),i.applyMatrix3(this.spaces[r].fromXYZ)),this.spaces[r].transfer===Wt&&(i.r=wA(i.r),i.g=wA(i.g),i.b=wA(i.b))),i},workingToColorSpace:function(i,s){return this.convert(i,this.workingColorSpace,s)},colorSpaceToWorking:function(i,s){return this.convert(i,s,this.workingColorSpace)},getPrimaries:function(i){return this.spaces[i].primaries},getTransfer:function(i){return i===Qn?zA:this.spaces[i].transfer},getToneMappingMode:function(i){return this.spaces[i].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(i,s=this.workingColorSpace){return i.fromArray(this.spaces[s].luminanceCoefficients)},define:function(i){Object.assign(this.spaces,i)},_getMatrix:function(i,s,r){return i.copy(this.spaces[r].fromXYZ).multiply(this.spaces[s].toXYZ)},_getDrawingBufferColorSpace:function(i){return this.spaces[i].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(i=this.workingColorSpace){return this.spaces[i].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return A.define({[kA]:{primaries:t,whitePoint:n,transfer:zA,toXYZ:ha,fromXYZ:ua,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Ce},outputColorSpaceConfig:{drawingBufferColorSpace:Ce}},[Ce]:{primaries:t,whitePoint:n,transfer:Wt,toXYZ:ha,fromXYZ:ua,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Ce}}}),A}var kt=gl();function Mn(A){return A<.04045?A*.0773993808:Math.pow(A*.9478672986+.0521327014,2.4)}function wA(A){return A<.0031308?A*12.92:1.055*Math.pow(A,.41666)-.055}var rA,cs=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{rA===void 0&&(rA=VA("canvas")),rA.width=t.width,rA.height=t.height;let i=rA.getContext("2d");t instanceof ImageData?i.putImageData(t,0,0):i.drawImage(t,0,0,t.width,t.height),n=rA}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=VA("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let i=n.getImageData(0,0,t.width,t.height),s=i.data;for(let r=0;r<s.length;r++)s[r]=Mn(s[r]/255)*255;return n.putImageData(i,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Mn(e[n]/255)*255):e[n]=Mn(e[n]);return{data:e,width:t.width,height:t.height}}else return yt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},pl=0,vA=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:pl++}),this.uuid=mi(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},i=this.data;if(i!==null){let s;if(Array.isArray(i)){s=[];for(let r=0,o=i.length;r<o;r++)i[r].isDataTexture?s.push(Fr(i[r].image)):s.push(Fr(i[r]))}else s=Fr(i);n.url=s}return e||(t.images[this.uuid]=n),n}};function Fr(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap?cs.getDataURL(A):A.data?{data:Array.from(A.data),width:A.width,height:A.height,type:A.data.constructor.name}:(yt("Texture: Unable to serialize Texture."),{})}var ml=0,Ur=new R,Pe=class A extends cn{constructor(t=A.DEFAULT_IMAGE,e=A.DEFAULT_MAPPING,n=an,i=an,s=Ie,r=yn,o=sn,c=Ue,a=A.DEFAULT_ANISOTROPY,l=Qn){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:ml++}),this.uuid=mi(),this.name="",this.source=new vA(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=i,this.magFilter=s,this.minFilter=r,this.anisotropy=a,this.format=o,this.internalFormat=null,this.type=c,this.offset=new Vt(0,0),this.repeat=new Vt(1,1),this.center=new Vt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new bt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=l,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Ur).x}get height(){return this.source.getSize(Ur).y}get depth(){return this.source.getSize(Ur).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){yt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let i=this[e];if(i===void 0){yt(`Texture.setValues(): property '${e}' does not exist.`);continue}i&&n&&i.isVector2&&n.isVector2||i&&n&&i.isVector3&&n.isVector3||i&&n&&i.isMatrix3&&n.isMatrix3?i.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Eo)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ss:t.x=t.x-Math.floor(t.x);break;case an:t.x=t.x<0?0:1;break;case rs:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ss:t.y=t.y-Math.floor(t.y);break;case an:t.y=t.y<0?0:1;break;case rs:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Pe.DEFAULT_IMAGE=null;Pe.DEFAULT_MAPPING=Eo;Pe.DEFAULT_ANISOTROPY=1;var Ae=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,i=1){this.x=t,this.y=e,this.z=n,this.w=i}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,i){return this.x=t,this.y=e,this.z=n,this.w=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,i=this.z,s=this.w,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*i+r[12]*s,this.y=r[1]*e+r[5]*n+r[9]*i+r[13]*s,this.z=r[2]*e+r[6]*n+r[10]*i+r[14]*s,this.w=r[3]*e+r[7]*n+r[11]*i+r[15]*s,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,i,s,c=t.elements,a=c[0],l=c[4],g=c[8],h=c[1],d=c[5],m=c[9],C=c[2],f=c[6],u=c[10];if(Math.abs(l-h)<.01&&Math.abs(g-C)<.01&&Math.abs(m-f)<.01){if(Math.abs(l+h)<.1&&Math.abs(g+C)<.1&&Math.abs(m+f)<.1&&Math.abs(a+d+u-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let _=(a+1)/2,D=(d+1)/2,S=(u+1)/2,x=(l+h)/4,p=(g+C)/4,v=(m+f)/4;return _>D&&_>S?_<.01?(n=0,i=.707106781,s=.707106781):(n=Math.sqrt(_),i=x/n,s=p/n):D>S?D<.01?(n=.707106781,i=0,s=.707106781):(i=Math.sqrt(D),n=x/i,s=v/i):S<.01?(n=.707106781,i=.707106781,s=0):(s=Math.sqrt(S),n=p/s,i=v/s),this.set(n,i,s,e),this}let E=Math.sqrt((f-m)*(f-m)+(g-C)*(g-C)+(h-l)*(h-l));return Math.abs(E)<.001&&(E=1),this.x=(f-m)/E,this.y=(g-C)/E,this.z=(h-l)/E,this.w=Math.acos((a+d+u-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=zt(this.x,t.x,e.x),this.y=zt(this.y,t.y,e.y),this.z=zt(this.z,t.z,e.z),this.w=zt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=zt(this.x,t,e),this.y=zt(this.y,t,e),this.z=zt(this.z,t,e),this.w=zt(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(zt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ls=class extends cn{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Ie,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new Ae(0,0,t,e),this.scissorTest=!1,this.viewport=new Ae(0,0,t,e),this.textures=[];let i=n.count;for(let s=0;s<i;s++)this.textures[s]=new Pe({width:t,height:e,depth:n.depth}),this.textures[s].isRenderTargetTexture=!0,this.textures[s].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Ie,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let i=0,s=this.textures.length;i<s;i++)this.textures[i].image.width=t,this.textures[i].image.height=e,this.textures[i].image.depth=n,this.textures[i].isData3DTexture!==!0&&(this.textures[i].isArrayTexture=this.textures[i].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let i=Object.assign({},t.textures[e].image);this.textures[e].source=new vA(i)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ge=class extends ls{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},YA=class extends Pe{constructor(t=null,e=1,n=1,i=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:i},this.magFilter=me,this.minFilter=me,this.wrapR=an,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var hs=class extends Pe{constructor(t=null,e=1,n=1,i=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:i},this.magFilter=me,this.minFilter=me,this.wrapR=an,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var te=class A{static{this.prototype.isMatrix4=!0}constructor(t,e,n,i,s,r,o,c,a,l,g,h,d,m,C,f){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,i,s,r,o,c,a,l,g,h,d,m,C,f)}set(t,e,n,i,s,r,o,c,a,l,g,h,d,m,C,f){let u=this.elements;return u[0]=t,u[4]=e,u[8]=n,u[12]=i,u[1]=s,u[5]=r,u[9]=o,u[13]=c,u[2]=a,u[6]=l,u[10]=g,u[14]=h,u[3]=d,u[7]=m,u[11]=C,u[15]=f,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new A().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,i=1/oA.setFromMatrixColumn(t,0).length(),s=1/oA.setFromMatrixColumn(t,1).length(),r=1/oA.setFromMatrixColumn(t,2).length();return e[0]=n[0]*i,e[1]=n[1]*i,e[2]=n[2]*i,e[3]=0,e[4]=n[4]*s,e[5]=n[5]*s,e[6]=n[6]*s,e[7]=0,e[8]=n[8]*r,e[9]=n[9]*r,e[10]=n[10]*r,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,i=t.y,s=t.z,r=Math.cos(n),o=Math.sin(n),c=Math.cos(i),a=Math.sin(i),l=Math.cos(s),g=Math.sin(s);if(t.order==="XYZ"){let h=r*l,d=r*g,m=o*l,C=o*g;e[0]=c*l,e[4]=-c*g,e[8]=a,e[1]=d+m*a,e[5]=h-C*a,e[9]=-o*c,e[2]=C-h*a,e[6]=m+d*a,e[10]=r*c}else if(t.order==="YXZ"){let h=c*l,d=c*g,m=a*l,C=a*g;e[0]=h+C*o,e[4]=m*o-d,e[8]=r*a,e[1]=r*g,e[5]=r*l,e[9]=-o,e[2]=d*o-m,e[6]=C+h*o,e[10]=r*c}else if(t.order==="ZXY"){let h=c*l,d=c*g,m=a*l,C=a*g;e[0]=h-C*o,e[4]=-r*g,e[8]=m+d*o,e[1]=d+m*o,e[5]=r*l,e[9]=C-h*o,e[2]=-r*a,e[6]=o,e[10]=r*c}else if(t.order==="ZYX"){let h=r*l,d=r*g,m=o*l,C=o*g;e[0]=c*l,e[4]=m*a-d,e[8]=h*a+C,e[1]=c*g,e[5]=C*a+h,e[9]=d*a-m,e[2]=-a,e[6]=o*c,e[10]=r*c}else if(t.order==="YZX"){let h=r*c,d=r*a,m=o*c,C=o*a;e[0]=c*l,e[4]=C-h*g,e[8]=m*g+d,e[1]=g,e[5]=r*l,e[9]=-o*l,e[2]=-a*l,e[6]=d*g+m,e[10]=h-C*g}else if(t.order==="XZY"){let h=r*c,d=r*a,m=o*c,C=o*a;e[0]=c*l,e[4]=-g,e[8]=a*l,e[1]=h*g+C,e[5]=r*l,e[9]=d*g-m,e[2]=m*g-d,e[6]=o*l,e[10]=C*g+h}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(Bl,t,wl)}lookAt(t,e,n){let i=this.elements;return Re.subVectors(t,e),Re.lengthSq()===0&&(Re.z=1),Re.normalize(),Tn.crossVectors(n,Re),Tn.lengthSq()===0&&(Math.abs(n.z)===1?Re.x+=1e-4:Re.z+=1e-4,Re.normalize(),Tn.crossVectors(n,Re)),Tn.normalize(),Di.crossVectors(Re,Tn),i[0]=Tn.x,i[4]=Di.x,i[8]=Re.x,i[1]=Tn.y,i[5]=Di.y,i[9]=Re.y,i[2]=Tn.z,i[6]=Di.z,i[10]=Re.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,i=e.elements,s=this.elements,r=n[0],o=n[4],c=n[8],a=n[12],l=n[1],g=n[5],h=n[9],d=n[13],m=n[2],C=n[6],f=n[10],u=n[14],E=n[3],_=n[7],D=n[11],S=n[15],x=i[0],p=i[4],v=i[8],N=i[12],b=i[1],P=i[5],O=i[9],J=i[13],I=i[2],V=i[6],q=i[10],G=i[14],et=i[3],z=i[7],j=i[11],$=i[15];return s[0]=r*x+o*b+c*I+a*et,s[4]=r*p+o*P+c*V+a*z,s[8]=r*v+o*O+c*q+a*j,s[12]=r*N+o*J+c*G+a*$,s[1]=l*x+g*b+h*I+d*et,s[5]=l*p+g*P+h*V+d*z,s[9]=l*v+g*O+h*q+d*j,s[13]=l*N+g*J+h*G+d*$,s[2]=m*x+C*b+f*I+u*et,s[6]=m*p+C*P+f*V+u*z,s[10]=m*v+C*O+f*q+u*j,s[14]=m*N+C*J+f*G+u*$,s[3]=E*x+_*b+D*I+S*et,s[7]=E*p+_*P+D*V+S*z,s[11]=E*v+_*O+D*q+S*j,s[15]=E*N+_*J+D*G+S*$,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],i=t[8],s=t[12],r=t[1],o=t[5],c=t[9],a=t[13],l=t[2],g=t[6],h=t[10],d=t[14],m=t[3],C=t[7],f=t[11],u=t[15],E=c*d-a*h,_=o*d-a*g,D=o*h-c*g,S=r*d-a*l,x=r*h-c*l,p=r*g-o*l;return e*(C*E-f*_+u*D)-n*(m*E-f*S+u*x)+i*(m*_-C*S+u*p)-s*(m*D-C*x+f*p)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],i=t[8],s=t[1],r=t[5],o=t[9],c=t[2],a=t[6],l=t[10];return e*(r*l-o*a)-n*(s*l-o*c)+i*(s*a-r*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let i=this.elements;return t.isVector3?(i[12]=t.x,i[13]=t.y,i[14]=t.z):(i[12]=t,i[13]=e,i[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],i=t[2],s=t[3],r=t[4],o=t[5],c=t[6],a=t[7],l=t[8],g=t[9],h=t[10],d=t[11],m=t[12],C=t[13],f=t[14],u=t[15],E=e*o-n*r,_=e*c-i*r,D=e*a-s*r,S=n*c-i*o,x=n*a-s*o,p=i*a-s*c,v=l*C-g*m,N=l*f-h*m,b=l*u-d*m,P=g*f-h*C,O=g*u-d*C,J=h*u-d*f,I=E*J-_*O+D*P+S*b-x*N+p*v;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let V=1/I;return t[0]=(o*J-c*O+a*P)*V,t[1]=(i*O-n*J-s*P)*V,t[2]=(C*p-f*x+u*S)*V,t[3]=(h*x-g*p-d*S)*V,t[4]=(c*b-r*J-a*N)*V,t[5]=(e*J-i*b+s*N)*V,t[6]=(f*D-m*p-u*_)*V,t[7]=(l*p-h*D+d*_)*V,t[8]=(r*O-o*b+a*v)*V,t[9]=(n*b-e*O-s*v)*V,t[10]=(m*x-C*D+u*E)*V,t[11]=(g*D-l*x-d*E)*V,t[12]=(o*N-r*P-c*v)*V,t[13]=(e*P-n*N+i*v)*V,t[14]=(C*_-m*S-f*E)*V,t[15]=(l*S-g*_+h*E)*V,this}scale(t){let e=this.elements,n=t.x,i=t.y,s=t.z;return e[0]*=n,e[4]*=i,e[8]*=s,e[1]*=n,e[5]*=i,e[9]*=s,e[2]*=n,e[6]*=i,e[10]*=s,e[3]*=n,e[7]*=i,e[11]*=s,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],i=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,i))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),i=Math.sin(e),s=1-n,r=t.x,o=t.y,c=t.z,a=s*r,l=s*o;return this.set(a*r+n,a*o-i*c,a*c+i*o,0,a*o+i*c,l*o+n,l*c-i*r,0,a*c-i*o,l*c+i*r,s*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,i,s,r){return this.set(1,n,s,0,t,1,r,0,e,i,1,0,0,0,0,1),this}compose(t,e,n){let i=this.elements,s=e._x,r=e._y,o=e._z,c=e._w,a=s+s,l=r+r,g=o+o,h=s*a,d=s*l,m=s*g,C=r*l,f=r*g,u=o*g,E=c*a,_=c*l,D=c*g,S=n.x,x=n.y,p=n.z;return i[0]=(1-(C+u))*S,i[1]=(d+D)*S,i[2]=(m-_)*S,i[3]=0,i[4]=(d-D)*x,i[5]=(1-(h+u))*x,i[6]=(f+E)*x,i[7]=0,i[8]=(m+_)*p,i[9]=(f-E)*p,i[10]=(1-(h+C))*p,i[11]=0,i[12]=t.x,i[13]=t.y,i[14]=t.z,i[15]=1,this}decompose(t,e,n){let i=this.elements;t.x=i[12],t.y=i[13],t.z=i[14];let s=this.determinantAffine();if(s===0)return n.set(1,1,1),e.identity(),this;let r=oA.set(i[0],i[1],i[2]).length(),o=oA.set(i[4],i[5],i[6]).length(),c=oA.set(i[8],i[9],i[10]).length();s<0&&(r=-r),Ze.copy(this);let a=1/r,l=1/o,g=1/c;return Ze.elements[0]*=a,Ze.elements[1]*=a,Ze.elements[2]*=a,Ze.elements[4]*=l,Ze.elements[5]*=l,Ze.elements[6]*=l,Ze.elements[8]*=g,Ze.elements[9]*=g,Ze.elements[10]*=g,e.setFromRotationMatrix(Ze),n.x=r,n.y=o,n.z=c,this}makePerspective(t,e,n,i,s,r,o=Xe,c=!1){let a=this.elements,l=2*s/(e-t),g=2*s/(n-i),h=(e+t)/(e-t),d=(n+i)/(n-i),m,C;if(c)m=s/(r-s),C=r*s/(r-s);else if(o===Xe)m=-(r+s)/(r-s),C=-2*r*s/(r-s);else if(o===EA)m=-r/(r-s),C=-r*s/(r-s);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+o);return a[0]=l,a[4]=0,a[8]=h,a[12]=0,a[1]=0,a[5]=g,a[9]=d,a[13]=0,a[2]=0,a[6]=0,a[10]=m,a[14]=C,a[3]=0,a[7]=0,a[11]=-1,a[15]=0,this}makeOrthographic(t,e,n,i,s,r,o=Xe,c=!1){let a=this.elements,l=2/(e-t),g=2/(n-i),h=-(e+t)/(e-t),d=-(n+i)/(n-i),m,C;if(c)m=1/(r-s),C=r/(r-s);else if(o===Xe)m=-2/(r-s),C=-(r+s)/(r-s);else if(o===EA)m=-1/(r-s),C=-s/(r-s);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+o);return a[0]=l,a[4]=0,a[8]=0,a[12]=h,a[1]=0,a[5]=g,a[9]=0,a[13]=d,a[2]=0,a[6]=0,a[10]=m,a[14]=C,a[3]=0,a[7]=0,a[11]=0,a[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let i=0;i<16;i++)if(e[i]!==n[i])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},oA=new R,Ze=new te,Bl=new R(0,0,0),wl=new R(1,1,1),Tn=new R,Di=new R,Re=new R,fa=new te,da=new Oe,Dn=class A{constructor(t=0,e=0,n=0,i=A.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=i}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,i=this._order){return this._x=t,this._y=e,this._z=n,this._order=i,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let i=t.elements,s=i[0],r=i[4],o=i[8],c=i[1],a=i[5],l=i[9],g=i[2],h=i[6],d=i[10];switch(e){case"XYZ":this._y=Math.asin(zt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(-l,d),this._z=Math.atan2(-r,s)):(this._x=Math.atan2(h,a),this._z=0);break;case"YXZ":this._x=Math.asin(-zt(l,-1,1)),Math.abs(l)<.9999999?(this._y=Math.atan2(o,d),this._z=Math.atan2(c,a)):(this._y=Math.atan2(-g,s),this._z=0);break;case"ZXY":this._x=Math.asin(zt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-g,d),this._z=Math.atan2(-r,a)):(this._y=0,this._z=Math.atan2(c,s));break;case"ZYX":this._y=Math.asin(-zt(g,-1,1)),Math.abs(g)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(c,s)):(this._x=0,this._z=Math.atan2(-r,a));break;case"YZX":this._z=Math.asin(zt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-l,a),this._y=Math.atan2(-g,s)):(this._x=0,this._y=Math.atan2(o,d));break;case"XZY":this._z=Math.asin(-zt(r,-1,1)),Math.abs(r)<.9999999?(this._x=Math.atan2(h,a),this._y=Math.atan2(o,s)):(this._x=Math.atan2(-l,d),this._y=0);break;default:yt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return fa.makeRotationFromQuaternion(t),this.setFromRotationMatrix(fa,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return da.setFromEuler(this),this.setFromQuaternion(da,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Dn.DEFAULT_ORDER="XYZ";var JA=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Cl=0,ga=new R,aA=new Oe,pn=new te,xi=new R,UA=new R,El=new R,Ml=new Oe,pa=new R(1,0,0),ma=new R(0,1,0),Ba=new R(0,0,1),wa={type:"added"},vl={type:"removed"},cA={type:"childadded",child:null},Rr={type:"childremoved",child:null},Me=class A extends cn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Cl++}),this.uuid=mi(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=A.DEFAULT_UP.clone();let t=new R,e=new Dn,n=new Oe,i=new R(1,1,1);function s(){n.setFromEuler(e,!1)}function r(){e.setFromQuaternion(n,void 0,!1)}e._onChange(s),n._onChange(r),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:i},modelViewMatrix:{value:new te},normalMatrix:{value:new bt}}),this.matrix=new te,this.matrixWorld=new te,this.matrixAutoUpdate=A.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=A.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new JA,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return aA.setFromAxisAngle(t,e),this.quaternion.multiply(aA),this}rotateOnWorldAxis(t,e){return aA.setFromAxisAngle(t,e),this.quaternion.premultiply(aA),this}rotateX(t){return this.rotateOnAxis(pa,t)}rotateY(t){return this.rotateOnAxis(ma,t)}rotateZ(t){return this.rotateOnAxis(Ba,t)}translateOnAxis(t,e){return ga.copy(t).applyQuaternion(this.quaternion),this.position.add(ga.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(pa,t)}translateY(t){return this.translateOnAxis(ma,t)}translateZ(t){return this.translateOnAxis(Ba,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(pn.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?xi.copy(t):xi.set(t,e,n);let i=this.parent;this.updateWorldMatrix(!0,!1),UA.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?pn.lookAt(UA,xi,this.up):pn.lookAt(xi,UA,this.up),this.quaternion.setFromRotationMatrix(pn),i&&(pn.extractRotation(i.matrixWorld),aA.setFromRotationMatrix(pn),this.quaternion.premultiply(aA.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Qt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(wa),cA.child=t,this.dispatchEvent(cA),cA.child=null):Qt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(vl),Rr.child=t,this.dispatchEvent(Rr),Rr.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),pn.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),pn.multiply(t.parent.matrixWorld)),t.applyMatrix4(pn),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(wa),cA.child=t,this.dispatchEvent(cA),cA.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,i=this.children.length;n<i;n++){let r=this.children[n].getObjectByProperty(t,e);if(r!==void 0)return r}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let i=this.children;for(let s=0,r=i.length;s<r;s++)i[s].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(UA,t,El),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(UA,Ml,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,i=t.z,s=this.matrix.elements;s[12]+=e-s[0]*e-s[4]*n-s[8]*i,s[13]+=n-s[1]*e-s[5]*n-s[9]*i,s[14]+=i-s[2]*e-s[6]*n-s[10]*i}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,i=e.length;n<i;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let i=this.parent;if(t===!0&&i!==null&&i.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let i={};i.uuid=this.uuid,i.type=this.type,i.name=this.name,i.castShadow=this.castShadow,i.receiveShadow=this.receiveShadow,i.visible=this.visible,i.frustumCulled=this.frustumCulled,i.renderOrder=this.renderOrder,i.static=this.static,i.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(i.userData=this.userData),i.layers=this.layers.mask,i.matrix=this.matrix.toArray(),i.up=this.up.toArray(),this.pivot!==null&&(i.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(i.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(i.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(i.type="InstancedMesh",i.count=this.count,i.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(i.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(i.type="BatchedMesh",i.perObjectFrustumCulled=this.perObjectFrustumCulled,i.sortObjects=this.sortObjects,i.drawRanges=this._drawRanges,i.reservedRanges=this._reservedRanges,i.geometryInfo=this._geometryInfo.map(o=>({...o,boundingBox:o.boundingBox?o.boundingBox.toJSON():void 0,boundingSphere:o.boundingSphere?o.boundingSphere.toJSON():void 0})),i.instanceInfo=this._instanceInfo.map(o=>({...o})),i.availableInstanceIds=this._availableInstanceIds.slice(),i.availableGeometryIds=this._availableGeometryIds.slice(),i.nextIndexStart=this._nextIndexStart,i.nextVertexStart=this._nextVertexStart,i.geometryCount=this._geometryCount,i.maxInstanceCount=this._maxInstanceCount,i.maxVertexCount=this._maxVertexCount,i.maxIndexCount=this._maxIndexCount,i.geometryInitialized=this._geometryInitialized,i.matricesTexture=this._matricesTexture.toJSON(t),i.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(i.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(i.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(i.boundingBox=this.boundingBox.toJSON()));function s(o,c){return o[c.uuid]===void 0&&(o[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?i.background=this.background.toJSON():this.background.isTexture&&(i.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(i.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){i.geometry=s(t.geometries,this.geometry);let o=this.geometry.parameters;if(o!==void 0&&o.shapes!==void 0){let c=o.shapes;if(Array.isArray(c))for(let a=0,l=c.length;a<l;a++){let g=c[a];s(t.shapes,g)}else s(t.shapes,c)}}if(this.isSkinnedMesh&&(i.bindMode=this.bindMode,i.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(s(t.skeletons,this.skeleton),i.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let o=[];for(let c=0,a=this.material.length;c<a;c++)o.push(s(t.materials,this.material[c]));i.material=o}else i.material=s(t.materials,this.material);if(this.children.length>0){i.children=[];for(let o=0;o<this.children.length;o++)i.children.push(this.children[o].toJSON(t).object)}if(this.animations.length>0){i.animations=[];for(let o=0;o<this.animations.length;o++){let c=this.animations[o];i.animations.push(s(t.animations,c))}}if(e){let o=r(t.geometries),c=r(t.materials),a=r(t.textures),l=r(t.images),g=r(t.shapes),h=r(t.skeletons),d=r(t.animations),m=r(t.nodes);o.length>0&&(n.geometries=o),c.length>0&&(n.materials=c),a.length>0&&(n.textures=a),l.length>0&&(n.images=l),g.length>0&&(n.shapes=g),h.length>0&&(n.skeletons=h),d.length>0&&(n.animations=d),m.length>0&&(n.nodes=m)}return n.object=i,n;function r(o){let c=[];for(let a in o){let l=o[a];delete l.metadata,c.push(l)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let i=t.children[n];this.add(i.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Me.DEFAULT_UP=new R(0,1,0);Me.DEFAULT_MATRIX_AUTO_UPDATE=!0;Me.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ne=class extends Me{constructor(){super(),this.isGroup=!0,this.type="Group"}},Dl={type:"move"},DA=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ne,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ne,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new R,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new R),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ne,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new R,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new R,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let i=null,s=null,r=null,o=this._targetRay,c=this._grip,a=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(a&&t.hand){r=!0;for(let C of t.hand.values()){let f=e.getJointPose(C,n),u=this._getHandJoint(a,C);f!==null&&(u.matrix.fromArray(f.transform.matrix),u.matrix.decompose(u.position,u.quaternion,u.scale),u.matrixWorldNeedsUpdate=!0,u.jointRadius=f.radius),u.visible=f!==null}let l=a.joints["index-finger-tip"],g=a.joints["thumb-tip"],h=l.position.distanceTo(g.position),d=.02,m=.005;a.inputState.pinching&&h>d+m?(a.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!a.inputState.pinching&&h<=d-m&&(a.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(s=e.getPose(t.gripSpace,n),s!==null&&(c.matrix.fromArray(s.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,s.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(s.linearVelocity)):c.hasLinearVelocity=!1,s.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(s.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));o!==null&&(i=e.getPose(t.targetRaySpace,n),i===null&&s!==null&&(i=s),i!==null&&(o.matrix.fromArray(i.transform.matrix),o.matrix.decompose(o.position,o.quaternion,o.scale),o.matrixWorldNeedsUpdate=!0,i.linearVelocity?(o.hasLinearVelocity=!0,o.linearVelocity.copy(i.linearVelocity)):o.hasLinearVelocity=!1,i.angularVelocity?(o.hasAngularVelocity=!0,o.angularVelocity.copy(i.angularVelocity)):o.hasAngularVelocity=!1,this.dispatchEvent(Dl)))}return o!==null&&(o.visible=i!==null),c!==null&&(c.visible=s!==null),a!==null&&(a.visible=r!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new Ne;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},Cc={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Pn={h:0,s:0,l:0},_i={h:0,s:0,l:0};function Lr(A,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?A+(t-A)*6*e:e<1/2?t:e<2/3?A+(t-A)*6*(2/3-e):A}var It=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let i=t;i&&i.isColor?this.copy(i):typeof i=="number"?this.setHex(i):typeof i=="string"&&this.setStyle(i)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Ce){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,kt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,i=kt.workingColorSpace){return this.r=t,this.g=e,this.b=n,kt.colorSpaceToWorking(this,i),this}setHSL(t,e,n,i=kt.workingColorSpace){if(t=ul(t,1),e=zt(e,0,1),n=zt(n,0,1),e===0)this.r=this.g=this.b=n;else{let s=n<=.5?n*(1+e):n+e-n*e,r=2*n-s;this.r=Lr(r,s,t+1/3),this.g=Lr(r,s,t),this.b=Lr(r,s,t-1/3)}return kt.colorSpaceToWorking(this,i),this}setStyle(t,e=Ce){function n(s){s!==void 0&&parseFloat(s)<1&&yt("Color: Alpha component of "+t+" will be ignored.")}let i;if(i=/^(\w+)\(([^\)]*)\)/.exec(t)){let s,r=i[1],o=i[2];switch(r){case"rgb":case"rgba":if(s=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(s[4]),this.setRGB(Math.min(255,parseInt(s[1],10))/255,Math.min(255,parseInt(s[2],10))/255,Math.min(255,parseInt(s[3],10))/255,e);if(s=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(s[4]),this.setRGB(Math.min(100,parseFloat(s[1]))/100,Math.min(100,parseFloat(s[2]))/100,Math.min(100,parseFloat(s[3]))/100,e);break;case"hsl":case"hsla":if(s=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(o))return n(s[4]),this.setHSL(parseFloat(s[1])/360,parseFloat(s[2])/100,parseFloat(s[3])/100,e);break;default:yt("Color: Unknown color model "+t)}}else if(i=/^\#([A-Fa-f\d]+)$/.exec(t)){let s=i[1],r=s.length;if(r===3)return this.setRGB(parseInt(s.charAt(0),16)/15,parseInt(s.charAt(1),16)/15,parseInt(s.charAt(2),16)/15,e);if(r===6)return this.setHex(parseInt(s,16),e);yt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Ce){let n=Cc[t.toLowerCase()];return n!==void 0?this.setHex(n,e):yt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Mn(t.r),this.g=Mn(t.g),this.b=Mn(t.b),this}copyLinearToSRGB(t){return this.r=wA(t.r),this.g=wA(t.g),this.b=wA(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Ce){return kt.workingToColorSpace(_e.copy(this),t),Math.round(zt(_e.r*255,0,255))*65536+Math.round(zt(_e.g*255,0,255))*256+Math.round(zt(_e.b*255,0,255))}getHexString(t=Ce){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=kt.workingColorSpace){kt.workingToColorSpace(_e.copy(this),e);let n=_e.r,i=_e.g,s=_e.b,r=Math.max(n,i,s),o=Math.min(n,i,s),c,a,l=(o+r)/2;if(o===r)c=0,a=0;else{let g=r-o;switch(a=l<=.5?g/(r+o):g/(2-r-o),r){case n:c=(i-s)/g+(i<s?6:0);break;case i:c=(s-n)/g+2;break;case s:c=(n-i)/g+4;break}c/=6}return t.h=c,t.s=a,t.l=l,t}getRGB(t,e=kt.workingColorSpace){return kt.workingToColorSpace(_e.copy(this),e),t.r=_e.r,t.g=_e.g,t.b=_e.b,t}getStyle(t=Ce){kt.workingToColorSpace(_e.copy(this),t);let e=_e.r,n=_e.g,i=_e.b;return t!==Ce?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${i.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(i*255)})`}offsetHSL(t,e,n){return this.getHSL(Pn),this.setHSL(Pn.h+t,Pn.s+e,Pn.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL(Pn),t.getHSL(_i);let n=br(Pn.h,_i.h,e),i=br(Pn.s,_i.s,e),s=br(Pn.l,_i.l,e);return this.setHSL(n,i,s),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,i=this.b,s=t.elements;return this.r=s[0]*e+s[3]*n+s[6]*i,this.g=s[1]*e+s[4]*n+s[7]*i,this.b=s[2]*e+s[5]*n+s[8]*i,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},_e=new It;It.NAMES=Cc;var WA=class extends Me{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Dn,this.environmentIntensity=1,this.environmentRotation=new Dn,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},je=new R,mn=new R,Nr=new R,Bn=new R,lA=new R,hA=new R,Ca=new R,Hr=new R,Or=new R,Gr=new R,kr=new Ae,zr=new Ae,Vr=new Ae,En=class A{constructor(t=new R,e=new R,n=new R){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,i){i.subVectors(n,e),je.subVectors(t,e),i.cross(je);let s=i.lengthSq();return s>0?i.multiplyScalar(1/Math.sqrt(s)):i.set(0,0,0)}static getBarycoord(t,e,n,i,s){je.subVectors(i,e),mn.subVectors(n,e),Nr.subVectors(t,e);let r=je.dot(je),o=je.dot(mn),c=je.dot(Nr),a=mn.dot(mn),l=mn.dot(Nr),g=r*a-o*o;if(g===0)return s.set(0,0,0),null;let h=1/g,d=(a*c-o*l)*h,m=(r*l-o*c)*h;return s.set(1-d-m,m,d)}static containsPoint(t,e,n,i){return this.getBarycoord(t,e,n,i,Bn)===null?!1:Bn.x>=0&&Bn.y>=0&&Bn.x+Bn.y<=1}static getInterpolation(t,e,n,i,s,r,o,c){return this.getBarycoord(t,e,n,i,Bn)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(s,Bn.x),c.addScaledVector(r,Bn.y),c.addScaledVector(o,Bn.z),c)}static getInterpolatedAttribute(t,e,n,i,s,r){return kr.setScalar(0),zr.setScalar(0),Vr.setScalar(0),kr.fromBufferAttribute(t,e),zr.fromBufferAttribute(t,n),Vr.fromBufferAttribute(t,i),r.setScalar(0),r.addScaledVector(kr,s.x),r.addScaledVector(zr,s.y),r.addScaledVector(Vr,s.z),r}static isFrontFacing(t,e,n,i){return je.subVectors(n,e),mn.subVectors(t,e),je.cross(mn).dot(i)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,i){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[i]),this}setFromAttributeAndIndices(t,e,n,i){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,i),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return je.subVectors(this.c,this.b),mn.subVectors(this.a,this.b),je.cross(mn).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return A.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return A.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,i,s){return A.getInterpolation(t,this.a,this.b,this.c,e,n,i,s)}containsPoint(t){return A.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return A.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,i=this.b,s=this.c,r,o;lA.subVectors(i,n),hA.subVectors(s,n),Hr.subVectors(t,n);let c=lA.dot(Hr),a=hA.dot(Hr);if(c<=0&&a<=0)return e.copy(n);Or.subVectors(t,i);let l=lA.dot(Or),g=hA.dot(Or);if(l>=0&&g<=l)return e.copy(i);let h=c*g-l*a;if(h<=0&&c>=0&&l<=0&&c-l>0)return r=c/(c-l),e.copy(n).addScaledVector(lA,r);Gr.subVectors(t,s);let d=lA.dot(Gr),m=hA.dot(Gr);if(m>=0&&d<=m)return e.copy(s);let C=d*a-c*m;if(C<=0&&a>=0&&m<=0)return o=a/(a-m),e.copy(n).addScaledVector(hA,o);let f=l*m-d*g;if(f<=0&&g-l>=0&&d-m>=0)return Ca.subVectors(s,i),o=(g-l)/(g-l+(d-m)),e.copy(i).addScaledVector(Ca,o);let u=1/(f+C+h);return r=C*u,o=h*u,e.copy(n).addScaledVector(lA,r).addScaledVector(hA,o)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Ln=class{constructor(t=new R(1/0,1/0,1/0),e=new R(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint($e.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint($e.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=$e.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let s=n.getAttribute("position");if(e===!0&&s!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let r=0,o=s.count;r<o;r++)t.isMesh===!0?t.getVertexPosition(r,$e):$e.fromBufferAttribute(s,r),$e.applyMatrix4(t.matrixWorld),this.expandByPoint($e);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),yi.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),yi.copy(n.boundingBox)),yi.applyMatrix4(t.matrixWorld),this.union(yi)}let i=t.children;for(let s=0,r=i.length;s<r;s++)this.expandByObject(i[s],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,$e),$e.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(RA),Si.subVectors(this.max,RA),uA.subVectors(t.a,RA),fA.subVectors(t.b,RA),dA.subVectors(t.c,RA),Fn.subVectors(fA,uA),Un.subVectors(dA,fA),Kn.subVectors(uA,dA);let e=[0,-Fn.z,Fn.y,0,-Un.z,Un.y,0,-Kn.z,Kn.y,Fn.z,0,-Fn.x,Un.z,0,-Un.x,Kn.z,0,-Kn.x,-Fn.y,Fn.x,0,-Un.y,Un.x,0,-Kn.y,Kn.x,0];return!Yr(e,uA,fA,dA,Si)||(e=[1,0,0,0,1,0,0,0,1],!Yr(e,uA,fA,dA,Si))?!1:(Qi.crossVectors(Fn,Un),e=[Qi.x,Qi.y,Qi.z],Yr(e,uA,fA,dA,Si))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,$e).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize($e).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(wn[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),wn[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),wn[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),wn[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),wn[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),wn[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),wn[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),wn[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(wn),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},wn=[new R,new R,new R,new R,new R,new R,new R,new R],$e=new R,yi=new Ln,uA=new R,fA=new R,dA=new R,Fn=new R,Un=new R,Kn=new R,RA=new R,Si=new R,Qi=new R,Xn=new R;function Yr(A,t,e,n,i){for(let s=0,r=A.length-3;s<=r;s+=3){Xn.fromArray(A,s);let o=i.x*Math.abs(Xn.x)+i.y*Math.abs(Xn.y)+i.z*Math.abs(Xn.z),c=t.dot(Xn),a=e.dot(Xn),l=n.dot(Xn);if(Math.max(-Math.max(c,a,l),Math.min(c,a,l))>o)return!1}return!0}var ae=new R,Ii=new Vt,xl=0,He=class extends cn{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:xl++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=dc,this.updateRanges=[],this.gpuType=nn,this.version=0,this._normalizationScale=t!==void 0?Fo(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let i=0,s=this.itemSize;i<s;i++)this.array[t+i]=e.array[n+i];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)Ii.fromBufferAttribute(this,e),Ii.applyMatrix3(t),this.setXY(e,Ii.x,Ii.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)ae.fromBufferAttribute(this,e),ae.applyMatrix3(t),this.setXYZ(e,ae.x,ae.y,ae.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)ae.fromBufferAttribute(this,e),ae.applyMatrix4(t),this.setXYZ(e,ae.x,ae.y,ae.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)ae.fromBufferAttribute(this,e),ae.applyNormalMatrix(t),this.setXYZ(e,ae.x,ae.y,ae.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)ae.fromBufferAttribute(this,e),ae.transformDirection(t),this.setXYZ(e,ae.x,ae.y,ae.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=i,this}setXYZW(t,e,n,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=i,this.array[t+3]=s,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):fl(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):dl(t,this.array)}};var KA=class extends He{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var XA=class extends He{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var Ee=class extends He{constructor(t,e,n){super(new Float32Array(t),e,n)}},_l=new Ln,LA=new R,Jr=new R,jn=class{constructor(t=new R,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):_l.setFromPoints(t).getCenter(n);let i=0;for(let s=0,r=t.length;s<r;s++)i=Math.max(i,n.distanceToSquared(t[s]));return this.radius=Math.sqrt(i),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;LA.subVectors(t,this.center);let e=LA.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),i=(n-this.radius)*.5;this.center.addScaledVector(LA,i/n),this.radius+=i}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Jr.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(LA.copy(t.center).add(Jr)),this.expandByPoint(LA.copy(t.center).sub(Jr))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},yl=0,Ke=new te,Wr=new Me,gA=new R,Le=new Ln,NA=new Ln,pe=new R,ke=class A extends cn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:yl++}),this.uuid=mi(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(ll(t)?XA:KA)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let s=new bt().getNormalMatrix(t);n.applyNormalMatrix(s),n.needsUpdate=!0}let i=this.attributes.tangent;return i!==void 0&&(i.transformDirection(t),i.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Ke.makeRotationFromQuaternion(t),this.applyMatrix4(Ke),this}rotateX(t){return Ke.makeRotationX(t),this.applyMatrix4(Ke),this}rotateY(t){return Ke.makeRotationY(t),this.applyMatrix4(Ke),this}rotateZ(t){return Ke.makeRotationZ(t),this.applyMatrix4(Ke),this}translate(t,e,n){return Ke.makeTranslation(t,e,n),this.applyMatrix4(Ke),this}scale(t,e,n){return Ke.makeScale(t,e,n),this.applyMatrix4(Ke),this}lookAt(t){return Wr.lookAt(t),Wr.updateMatrix(),this.applyMatrix4(Wr.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(gA).negate(),this.translate(gA.x,gA.y,gA.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let i=0,s=t.length;i<s;i++){let r=t[i];n.push(r.x,r.y,r.z||0)}this.setAttribute("position",new Ee(n,3))}else{let n=Math.min(t.length,e.count);for(let i=0;i<n;i++){let s=t[i];e.setXYZ(i,s.x,s.y,s.z||0)}t.length>e.count&&yt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Ln);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new R(-1/0,-1/0,-1/0),new R(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,i=e.length;n<i;n++){let s=e[n];Le.setFromBufferAttribute(s),this.morphTargetsRelative?(pe.addVectors(this.boundingBox.min,Le.min),this.boundingBox.expandByPoint(pe),pe.addVectors(this.boundingBox.max,Le.max),this.boundingBox.expandByPoint(pe)):(this.boundingBox.expandByPoint(Le.min),this.boundingBox.expandByPoint(Le.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Qt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new jn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Qt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new R,1/0);return}if(t){let n=this.boundingSphere.center;if(Le.setFromBufferAttribute(t),e)for(let s=0,r=e.length;s<r;s++){let o=e[s];NA.setFromBufferAttribute(o),this.morphTargetsRelative?(pe.addVectors(Le.min,NA.min),Le.expandByPoint(pe),pe.addVectors(Le.max,NA.max),Le.expandByPoint(pe)):(Le.expandByPoint(NA.min),Le.expandByPoint(NA.max))}Le.getCenter(n);let i=0;for(let s=0,r=t.count;s<r;s++)pe.fromBufferAttribute(t,s),i=Math.max(i,n.distanceToSquared(pe));if(e)for(let s=0,r=e.length;s<r;s++){let o=e[s],c=this.morphTargetsRelative;for(let a=0,l=o.count;a<l;a++)pe.fromBufferAttribute(o,a),c&&(gA.fromBufferAttribute(t,a),pe.add(gA)),i=Math.max(i,n.distanceToSquared(pe))}this.boundingSphere.radius=Math.sqrt(i),isNaN(this.boundingSphere.radius)&&Qt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Qt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,i=e.normal,s=e.uv,r=this.getAttribute("tangent");(r===void 0||r.count!==n.count)&&(r=new He(new Float32Array(4*n.count),4),this.setAttribute("tangent",r));let o=[],c=[],a=new Uint8Array(n.count);for(let N=0;N<n.count;N++)o[N]=new R,c[N]=new R;let l=new R,g=new R,h=new R,d=new Vt,m=new Vt,C=new Vt,f=new R,u=new R;function E(N,b,P){a[N]=a[b]=a[P]=1,l.fromBufferAttribute(n,N),g.fromBufferAttribute(n,b),h.fromBufferAttribute(n,P),d.fromBufferAttribute(s,N),m.fromBufferAttribute(s,b),C.fromBufferAttribute(s,P),g.sub(l),h.sub(l),m.sub(d),C.sub(d);let O=1/(m.x*C.y-C.x*m.y);isFinite(O)&&(f.copy(g).multiplyScalar(C.y).addScaledVector(h,-m.y).multiplyScalar(O),u.copy(h).multiplyScalar(m.x).addScaledVector(g,-C.x).multiplyScalar(O),o[N].add(f),o[b].add(f),o[P].add(f),c[N].add(u),c[b].add(u),c[P].add(u))}let _=this.groups;_.length===0&&(_=[{start:0,count:t.count}]);for(let N=0,b=_.length;N<b;++N){let P=_[N],O=P.start,J=P.count;for(let I=O,V=O+J;I<V;I+=3)E(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let D=new R,S=new R,x=new R,p=new R;function v(N){x.fromBufferAttribute(i,N),p.copy(x);let b=o[N];D.copy(b),D.sub(x.multiplyScalar(x.dot(b))).normalize(),S.crossVectors(p,b);let O=S.dot(c[N])<0?-1:1;r.setXYZW(N,D.x,D.y,D.z,O)}for(let N=0,b=n.count;N<b;++N)a[N]&&v(N);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new He(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let h=0,d=n.count;h<d;h++)n.setXYZ(h,0,0,0);let i=new R,s=new R,r=new R,o=new R,c=new R,a=new R,l=new R,g=new R;if(t)for(let h=0,d=t.count;h<d;h+=3){let m=t.getX(h+0),C=t.getX(h+1),f=t.getX(h+2);i.fromBufferAttribute(e,m),s.fromBufferAttribute(e,C),r.fromBufferAttribute(e,f),l.subVectors(r,s),g.subVectors(i,s),l.cross(g),o.fromBufferAttribute(n,m),c.fromBufferAttribute(n,C),a.fromBufferAttribute(n,f),o.add(l),c.add(l),a.add(l),n.setXYZ(m,o.x,o.y,o.z),n.setXYZ(C,c.x,c.y,c.z),n.setXYZ(f,a.x,a.y,a.z)}else for(let h=0,d=e.count;h<d;h+=3)i.fromBufferAttribute(e,h+0),s.fromBufferAttribute(e,h+1),r.fromBufferAttribute(e,h+2),l.subVectors(r,s),g.subVectors(i,s),l.cross(g),n.setXYZ(h+0,l.x,l.y,l.z),n.setXYZ(h+1,l.x,l.y,l.z),n.setXYZ(h+2,l.x,l.y,l.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)pe.fromBufferAttribute(t,e),pe.normalize(),t.setXYZ(e,pe.x,pe.y,pe.z)}toNonIndexed(){function t(o,c){let a=o.array,l=o.itemSize,g=o.normalized,h=new a.constructor(c.length*l),d=0,m=0;for(let C=0,f=c.length;C<f;C++){o.isInterleavedBufferAttribute?d=c[C]*o.data.stride+o.offset:d=c[C]*l;for(let u=0;u<l;u++)h[m++]=a[d++]}return new He(h,l,g)}if(this.index===null)return yt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new A,n=this.index.array,i=this.attributes;for(let o in i){let c=i[o],a=t(c,n);e.setAttribute(o,a)}let s=this.morphAttributes;for(let o in s){let c=[],a=s[o];for(let l=0,g=a.length;l<g;l++){let h=a[l],d=t(h,n);c.push(d)}e.morphAttributes[o]=c}e.morphTargetsRelative=this.morphTargetsRelative;let r=this.groups;for(let o=0,c=r.length;o<c;o++){let a=r[o];e.addGroup(a.start,a.count,a.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let a in c)c[a]!==void 0&&(t[a]=c[a]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let a=n[c];t.data.attributes[c]=a.toJSON(t.data)}let i={},s=!1;for(let c in this.morphAttributes){let a=this.morphAttributes[c],l=[];for(let g=0,h=a.length;g<h;g++){let d=a[g];l.push(d.toJSON(t.data))}l.length>0&&(i[c]=l,s=!0)}s&&(t.data.morphAttributes=i,t.data.morphTargetsRelative=this.morphTargetsRelative);let r=this.groups;r.length>0&&(t.data.groups=JSON.parse(JSON.stringify(r)));let o=this.boundingSphere;return o!==null&&(t.data.boundingSphere=o.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let i=t.attributes;for(let a in i){let l=i[a];this.setAttribute(a,l.clone(e))}let s=t.morphAttributes;for(let a in s){let l=[],g=s[a];for(let h=0,d=g.length;h<d;h++)l.push(g[h].clone(e));this.morphAttributes[a]=l}this.morphTargetsRelative=t.morphTargetsRelative;let r=t.groups;for(let a=0,l=r.length;a<l;a++){let g=r[a];this.addGroup(g.start,g.count,g.materialIndex)}let o=t.boundingBox;o!==null&&(this.boundingBox=o.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Kr=new R,Sl=new R,Ql=new bt,tn=class{constructor(t=new R(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,i){return this.normal.set(t,e,n),this.constant=i,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let i=Kr.subVectors(n,e).cross(Sl.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(i,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let i=t.delta(Kr),s=this.normal.dot(i);if(s===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let r=-(t.start.dot(this.normal)+this.constant)/s;return n===!0&&(r<0||r>1)?null:e.copy(t.start).addScaledVector(i,r)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||Ql.getNormalMatrix(t),i=this.coplanarPoint(Kr).applyMatrix4(t),s=this.normal.applyMatrix3(n).normalize();return this.constant=-i.dot(s),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Il=0,xn=class extends cn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Il++}),this.uuid=mi(),this.name="",this.type="Material",this.blending=SA,this.side=zn,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=ho,this.blendDst=uo,this.blendEquation=nA,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new It(0,0,0),this.blendAlpha=0,this.depthFunc=CA,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=ac,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=qi,this.stencilZFail=qi,this.stencilZPass=qi,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){yt(`Material: parameter '${e}' has value of undefined.`);continue}let i=this[e];if(i===void 0){yt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}i&&i.isColor?i.set(n):i&&i.isVector2&&n&&n.isVector2||i&&i.isEuler&&n&&n.isEuler||i&&i.isVector3&&n&&n.isVector3?i.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(s=>s.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function i(s){let r=[];for(let o in s){let c=s[o];delete c.metadata,r.push(c)}return r}if(e){let s=i(t.textures),r=i(t.images);s.length>0&&(n.textures=s),r.length>0&&(n.images=r)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new It().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new tn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Vt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Vt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let i=e.length;n=new Array(i);for(let s=0;s!==i;++s)n[s]=e[s].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Cn=new R,Xr=new R,bi=new R,Ti=new R,qA=class{constructor(t=new R,e=new R(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Cn)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Cn.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Cn.copy(this.origin).addScaledVector(this.direction,e),Cn.distanceToSquared(t))}distanceSqToSegment(t,e,n,i){Xr.copy(t).add(e).multiplyScalar(.5),bi.copy(e).sub(t).normalize(),Ti.copy(this.origin).sub(Xr);let s=t.distanceTo(e)*.5,r=-this.direction.dot(bi),o=Ti.dot(this.direction),c=-Ti.dot(bi),a=Ti.lengthSq(),l=Math.abs(1-r*r),g,h,d,m;if(l>0)if(g=r*c-o,h=r*o-c,m=s*l,g>=0)if(h>=-m)if(h<=m){let C=1/l;g*=C,h*=C,d=g*(g+r*h+2*o)+h*(r*g+h+2*c)+a}else h=s,g=Math.max(0,-(r*h+o)),d=-g*g+h*(h+2*c)+a;else h=-s,g=Math.max(0,-(r*h+o)),d=-g*g+h*(h+2*c)+a;else h<=-m?(g=Math.max(0,-(-r*s+o)),h=g>0?-s:Math.min(Math.max(-s,-c),s),d=-g*g+h*(h+2*c)+a):h<=m?(g=0,h=Math.min(Math.max(-s,-c),s),d=h*(h+2*c)+a):(g=Math.max(0,-(r*s+o)),h=g>0?s:Math.min(Math.max(-s,-c),s),d=-g*g+h*(h+2*c)+a);else h=r>0?-s:s,g=Math.max(0,-(r*h+o)),d=-g*g+h*(h+2*c)+a;return n&&n.copy(this.origin).addScaledVector(this.direction,g),i&&i.copy(Xr).addScaledVector(bi,h),d}intersectSphere(t,e){if(t.radius<0)return null;Cn.subVectors(t.center,this.origin);let n=Cn.dot(this.direction),i=Cn.dot(Cn)-n*n,s=t.radius*t.radius;if(i>s)return null;let r=Math.sqrt(s-i),o=n-r,c=n+r;return c<0?null:o<0?this.at(c,e):this.at(o,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,i,s,r,o,c,a=1/this.direction.x,l=1/this.direction.y,g=1/this.direction.z,h=this.origin;return a>=0?(n=(t.min.x-h.x)*a,i=(t.max.x-h.x)*a):(n=(t.max.x-h.x)*a,i=(t.min.x-h.x)*a),l>=0?(s=(t.min.y-h.y)*l,r=(t.max.y-h.y)*l):(s=(t.max.y-h.y)*l,r=(t.min.y-h.y)*l),n>r||s>i||((s>n||isNaN(n))&&(n=s),(r<i||isNaN(i))&&(i=r),g>=0?(o=(t.min.z-h.z)*g,c=(t.max.z-h.z)*g):(o=(t.max.z-h.z)*g,c=(t.min.z-h.z)*g),n>c||o>i)||((o>n||n!==n)&&(n=o),(c<i||i!==i)&&(i=c),i<0)?null:this.at(n>=0?n:i,e)}intersectsBox(t){return this.intersectBox(t,Cn)!==null}intersectTriangle(t,e,n,i,s){let r=this.origin,o=this.direction,c=o.x,a=o.y,l=o.z,g=t.x-r.x,h=t.y-r.y,d=t.z-r.z,m=e.x-r.x,C=e.y-r.y,f=e.z-r.z,u=n.x-r.x,E=n.y-r.y,_=n.z-r.z,D=Math.abs(c),S=Math.abs(a),x=Math.abs(l),p,v,N,b,P,O,J,I,V,q,G,et;if(D>=S&&D>=x?(N=c,O=g,V=m,et=u,c>=0?(p=a,v=l,b=h,P=d,J=C,I=f,q=E,G=_):(p=l,v=a,b=d,P=h,J=f,I=C,q=_,G=E)):S>=x?(N=a,O=h,V=C,et=E,a>=0?(p=l,v=c,b=d,P=g,J=f,I=m,q=_,G=u):(p=c,v=l,b=g,P=d,J=m,I=f,q=u,G=_)):(N=l,O=d,V=f,et=_,l>=0?(p=c,v=a,b=g,P=h,J=m,I=C,q=u,G=E):(p=a,v=c,b=h,P=g,J=C,I=m,q=E,G=u)),N===0)return null;let z=p/N,j=v/N,$=1/N,Et=b-z*O,Pt=P-j*O,K=J-z*V,dt=I-j*V,Bt=q-z*et,xt=G-j*et,gt=Bt*dt-xt*K,Ut=Et*xt-Pt*Bt,re=K*Pt-dt*Et;if(i){if(gt<0||Ut<0||re<0)return null}else if((gt<0||Ut<0||re<0)&&(gt>0||Ut>0||re>0))return null;let St=gt+Ut+re;if(St===0)return null;let Kt=$*(gt*O+Ut*V+re*et);return(St>0?Kt<0:Kt>0)?null:this.at(Kt/St,s)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},us=class extends xn{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new It(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Dn,this.combine=Ps,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Ea=new te,qn=new qA,Pi=new jn,Ma=new R,Fi=new R,Ui=new R,Ri=new R,qr=new R,Li=new R,va=new R,Ni=new R,Fe=class extends Me{constructor(t=new ke,e=new us){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let i=e[n[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,r=i.length;s<r;s++){let o=i[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=s}}}}getVertexPosition(t,e){let n=this.geometry,i=n.attributes.position,s=n.morphAttributes.position,r=n.morphTargetsRelative;e.fromBufferAttribute(i,t);let o=this.morphTargetInfluences;if(s&&o){Li.set(0,0,0);for(let c=0,a=s.length;c<a;c++){let l=o[c],g=s[c];l!==0&&(qr.fromBufferAttribute(g,t),r?Li.addScaledVector(qr,l):Li.addScaledVector(qr.sub(e),l))}e.add(Li)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,i=this.material,s=this.matrixWorld;i!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),Pi.copy(n.boundingSphere),Pi.applyMatrix4(s),qn.copy(t.ray).recast(t.near),!(Pi.containsPoint(qn.origin)===!1&&(qn.intersectSphere(Pi,Ma)===null||qn.origin.distanceToSquared(Ma)>(t.far-t.near)**2))&&(Ea.copy(s).invert(),qn.copy(t.ray).applyMatrix4(Ea),!(n.boundingBox!==null&&qn.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,qn)))}_computeIntersections(t,e,n){let i,s=this.geometry,r=this.material,o=s.index,c=s.attributes.position,a=s.attributes.uv,l=s.attributes.uv1,g=s.attributes.normal,h=s.groups,d=s.drawRange;if(o!==null)if(Array.isArray(r))for(let m=0,C=h.length;m<C;m++){let f=h[m],u=r[f.materialIndex],E=Math.max(f.start,d.start),_=Math.min(o.count,Math.min(f.start+f.count,d.start+d.count));for(let D=E,S=_;D<S;D+=3){let x=o.getX(D),p=o.getX(D+1),v=o.getX(D+2);i=Hi(this,u,t,n,a,l,g,x,p,v),i&&(i.faceIndex=Math.floor(D/3),i.face.materialIndex=f.materialIndex,e.push(i))}}else{let m=Math.max(0,d.start),C=Math.min(o.count,d.start+d.count);for(let f=m,u=C;f<u;f+=3){let E=o.getX(f),_=o.getX(f+1),D=o.getX(f+2);i=Hi(this,r,t,n,a,l,g,E,_,D),i&&(i.faceIndex=Math.floor(f/3),e.push(i))}}else if(c!==void 0)if(Array.isArray(r))for(let m=0,C=h.length;m<C;m++){let f=h[m],u=r[f.materialIndex],E=Math.max(f.start,d.start),_=Math.min(c.count,Math.min(f.start+f.count,d.start+d.count));for(let D=E,S=_;D<S;D+=3){let x=D,p=D+1,v=D+2;i=Hi(this,u,t,n,a,l,g,x,p,v),i&&(i.faceIndex=Math.floor(D/3),i.face.materialIndex=f.materialIndex,e.push(i))}}else{let m=Math.max(0,d.start),C=Math.min(c.count,d.start+d.count);for(let f=m,u=C;f<u;f+=3){let E=f,_=f+1,D=f+2;i=Hi(this,r,t,n,a,l,g,E,_,D),i&&(i.faceIndex=Math.floor(f/3),e.push(i))}}}};function bl(A,t,e,n,i,s,r,o){let c;if(t.side===be?c=n.intersectTriangle(r,s,i,!0,o):c=n.intersectTriangle(i,s,r,t.side===zn,o),c===null)return null;Ni.copy(o),Ni.applyMatrix4(A.matrixWorld);let a=e.ray.origin.distanceTo(Ni);return a<e.near||a>e.far?null:{distance:a,point:Ni.clone(),object:A}}function Hi(A,t,e,n,i,s,r,o,c,a){A.getVertexPosition(o,Fi),A.getVertexPosition(c,Ui),A.getVertexPosition(a,Ri);let l=bl(A,t,e,n,Fi,Ui,Ri,va);if(l){let g=new R;En.getBarycoord(va,Fi,Ui,Ri,g),i&&(l.uv=En.getInterpolatedAttribute(i,o,c,a,g,new Vt)),s&&(l.uv1=En.getInterpolatedAttribute(s,o,c,a,g,new Vt)),r&&(l.normal=En.getInterpolatedAttribute(r,o,c,a,g,new R),l.normal.dot(n.direction)>0&&l.normal.multiplyScalar(-1));let h={a:o,b:c,c:a,normal:new R,materialIndex:0};En.getNormal(Fi,Ui,Ri,h.normal),l.face=h,l.barycoord=g}return l}var fs=class extends Pe{constructor(t=null,e=1,n=1,i,s,r,o,c,a=me,l=me,g,h){super(null,r,o,c,a,l,i,s,g,h),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Zn=new jn,Tl=new Vt(.5,.5),Oi=new R,Nn=class{constructor(t=new tn,e=new tn,n=new tn,i=new tn,s=new tn,r=new tn){this.planes=[t,e,n,i,s,r]}set(t,e,n,i,s,r){let o=this.planes;return o[0].copy(t),o[1].copy(e),o[2].copy(n),o[3].copy(i),o[4].copy(s),o[5].copy(r),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Xe,n=!1){let i=this.planes,s=t.elements,r=s[0],o=s[1],c=s[2],a=s[3],l=s[4],g=s[5],h=s[6],d=s[7],m=s[8],C=s[9],f=s[10],u=s[11],E=s[12],_=s[13],D=s[14],S=s[15];if(i[0].setComponents(a-r,d-l,u-m,S-E).normalize(),i[1].setComponents(a+r,d+l,u+m,S+E).normalize(),i[2].setComponents(a+o,d+g,u+C,S+_).normalize(),i[3].setComponents(a-o,d-g,u-C,S-_).normalize(),n)i[4].setComponents(c,h,f,D).normalize(),i[5].setComponents(a-c,d-h,u-f,S-D).normalize();else if(i[4].setComponents(a-c,d-h,u-f,S-D).normalize(),e===Xe)i[5].setComponents(a+c,d+h,u+f,S+D).normalize();else if(e===EA)i[5].setComponents(c,h,f,D).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Zn.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Zn.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Zn)}intersectsSprite(t){Zn.center.set(0,0,0);let e=Tl.distanceTo(t.center);return Zn.radius=.7071067811865476+e,Zn.applyMatrix4(t.matrixWorld),this.intersectsSphere(Zn)}intersectsSphere(t){let e=this.planes,n=t.center,i=-t.radius;for(let s=0;s<6;s++)if(e[s].distanceToPoint(n)<i)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let i=e[n];if(Oi.x=i.normal.x>0?t.max.x:t.min.x,Oi.y=i.normal.y>0?t.max.y:t.min.y,Oi.z=i.normal.z>0?t.max.z:t.min.z,i.distanceToPoint(Oi)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Da=new te,ds=class A{constructor(){this.coordinateSystem=Xe,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let i=0;i<e.length;i++){let s=e[i];Da.multiplyMatrices(s.projectionMatrix,s.matrixWorldInverse),n[i]===void 0&&(n[i]=new Nn),n[i].setFromProjectionMatrix(Da,s.coordinateSystem,s.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let i=0;i<t._count;i++)e[i]===void 0&&(e[i]=new Nn),e[i].copy(n[i]);return this._count=t._count,this}clone(){return new A().copy(this)}};var $n=class extends xn{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new It(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},gs=new R,ps=new R,xa=new te,HA=new qA,Gi=new jn,Zr=new R,_a=new R,ms=class extends Me{constructor(t=new ke,e=new $n){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let i=1,s=e.count;i<s;i++)gs.fromBufferAttribute(e,i-1),ps.fromBufferAttribute(e,i),n[i]=n[i-1],n[i]+=gs.distanceTo(ps);t.setAttribute("lineDistance",new Ee(n,1))}else yt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,i=this.matrixWorld,s=t.params.Line.threshold,r=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Gi.copy(n.boundingSphere),Gi.applyMatrix4(i),Gi.radius+=s,t.ray.intersectsSphere(Gi)===!1)return;xa.copy(i).invert(),HA.copy(t.ray).applyMatrix4(xa);let o=s/((this.scale.x+this.scale.y+this.scale.z)/3),c=o*o,a=this.isLineSegments?2:1,l=n.index,h=n.attributes.position;if(l!==null){let d=Math.max(0,r.start),m=Math.min(l.count,r.start+r.count);for(let C=d,f=m-1;C<f;C+=a){let u=l.getX(C),E=l.getX(C+1),_=ki(this,t,HA,c,u,E,C);_&&e.push(_)}if(this.isLineLoop){let C=l.getX(m-1),f=l.getX(d),u=ki(this,t,HA,c,C,f,m-1);u&&e.push(u)}}else{let d=Math.max(0,r.start),m=Math.min(h.count,r.start+r.count);for(let C=d,f=m-1;C<f;C+=a){let u=ki(this,t,HA,c,C,C+1,C);u&&e.push(u)}if(this.isLineLoop){let C=ki(this,t,HA,c,m-1,d,m-1);C&&e.push(C)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let i=e[n[0]];if(i!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let s=0,r=i.length;s<r;s++){let o=i[s].name||String(s);this.morphTargetInfluences.push(0),this.morphTargetDictionary[o]=s}}}}};function ki(A,t,e,n,i,s,r){let o=A.geometry.attributes.position;if(gs.fromBufferAttribute(o,i),ps.fromBufferAttribute(o,s),e.distanceSqToSegment(gs,ps,Zr,_a)>n)return;Zr.applyMatrix4(A.matrixWorld);let a=t.ray.origin.distanceTo(Zr);if(!(a<t.near||a>t.far))return{distance:a,point:_a.clone().applyMatrix4(A.matrixWorld),index:r,face:null,faceIndex:null,barycoord:null,object:A}}var ya=new R,Sa=new R,xA=class extends ms{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let i=0,s=e.count;i<s;i+=2)ya.fromBufferAttribute(e,i),Sa.fromBufferAttribute(e,i+1),n[i]=i===0?0:n[i-1],n[i+1]=n[i]+ya.distanceTo(Sa);t.setAttribute("lineDistance",new Ee(n,1))}else yt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var ZA=class extends Pe{constructor(t=[],e=AA,n,i,s,r,o,c,a,l){super(t,e,n,i,s,r,o,c,a,l),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var _n=class extends Pe{constructor(t,e,n=en,i,s,r,o=me,c=me,a,l=vn,g=1){if(l!==vn&&l!==Sn)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:t,height:e,depth:g};super(h,i,s,r,o,c,l,n,a),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new vA(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},jA=class extends _n{constructor(t,e=en,n=AA,i,s,r=me,o=me,c,a=vn){let l={width:t,height:t,depth:1},g=[l,l,l,l,l,l];super(t,t,e,n,i,s,r,o,c,a),this.image=g,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},$A=class extends Pe{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Hn=class A extends ke{constructor(t=1,e=1,n=1,i=1,s=1,r=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:i,heightSegments:s,depthSegments:r};let o=this;i=Math.floor(i),s=Math.floor(s),r=Math.floor(r);let c=[],a=[],l=[],g=[],h=0,d=0;m("z","y","x",-1,-1,n,e,t,r,s,0),m("z","y","x",1,-1,n,e,-t,r,s,1),m("x","z","y",1,1,t,n,e,i,r,2),m("x","z","y",1,-1,t,n,-e,i,r,3),m("x","y","z",1,-1,t,e,n,i,s,4),m("x","y","z",-1,-1,t,e,-n,i,s,5),this.setIndex(c),this.setAttribute("position",new Ee(a,3)),this.setAttribute("normal",new Ee(l,3)),this.setAttribute("uv",new Ee(g,2));function m(C,f,u,E,_,D,S,x,p,v,N){let b=D/p,P=S/v,O=D/2,J=S/2,I=x/2,V=p+1,q=v+1,G=0,et=0,z=new R;for(let j=0;j<q;j++){let $=j*P-J;for(let Et=0;Et<V;Et++){let Pt=Et*b-O;z[C]=Pt*E,z[f]=$*_,z[u]=I,a.push(z.x,z.y,z.z),z[C]=0,z[f]=0,z[u]=x>0?1:-1,l.push(z.x,z.y,z.z),g.push(Et/p),g.push(1-j/v),G+=1}}for(let j=0;j<v;j++)for(let $=0;$<p;$++){let Et=h+$+V*j,Pt=h+$+V*(j+1),K=h+($+1)+V*(j+1),dt=h+($+1)+V*j;c.push(Et,Pt,dt),c.push(Pt,K,dt),et+=6}o.addGroup(d,et,N),d+=et,h+=G}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new A(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var zi=new R,Vi=new R,jr=new R,Yi=new En,ti=class extends ke{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let i=Math.pow(10,4),s=Math.cos(Zi*e),r=t.getIndex(),o=t.getAttribute("position"),c=r?r.count:o.count,a=[0,0,0],l=["a","b","c"],g=new Array(3),h=new Map,d=[];for(let m=0;m<c;m+=3){r?(a[0]=r.getX(m),a[1]=r.getX(m+1),a[2]=r.getX(m+2)):(a[0]=m,a[1]=m+1,a[2]=m+2);let{a:C,b:f,c:u}=Yi;if(C.fromBufferAttribute(o,a[0]),f.fromBufferAttribute(o,a[1]),u.fromBufferAttribute(o,a[2]),Yi.getNormal(jr),g[0]=`${Math.round(C.x*i)},${Math.round(C.y*i)},${Math.round(C.z*i)}`,g[1]=`${Math.round(f.x*i)},${Math.round(f.y*i)},${Math.round(f.z*i)}`,g[2]=`${Math.round(u.x*i)},${Math.round(u.y*i)},${Math.round(u.z*i)}`,!(g[0]===g[1]||g[1]===g[2]||g[2]===g[0]))for(let E=0;E<3;E++){let _=(E+1)%3,D=g[E],S=g[_],x=Yi[l[E]],p=Yi[l[_]],v=`${D}_${S}`,N=`${S}_${D}`,b=h.get(N);b?(jr.dot(b.normal)<=s&&(d.push(x.x,x.y,x.z),d.push(p.x,p.y,p.z)),h.set(N,null)):h.has(v)||h.set(v,{index0:a[E],index1:a[_],normal:jr.clone()})}}for(let m of h.values())if(m){let{index0:C,index1:f}=m;zi.fromBufferAttribute(o,C),Vi.fromBufferAttribute(o,f),d.push(zi.x,zi.y,zi.z),d.push(Vi.x,Vi.y,Vi.z)}this.setAttribute("position",new Ee(d,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var ei=class A extends ke{constructor(t=1,e=1,n=1,i=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:i};let s=t/2,r=e/2,o=Math.floor(n),c=Math.floor(i),a=o+1,l=c+1,g=t/o,h=e/c,d=[],m=[],C=[],f=[];for(let u=0;u<l;u++){let E=u*h-r;for(let _=0;_<a;_++){let D=_*g-s;m.push(D,-E,0),C.push(0,0,1),f.push(_/o),f.push(1-u/c)}}for(let u=0;u<c;u++)for(let E=0;E<o;E++){let _=E+a*u,D=E+a*(u+1),S=E+1+a*(u+1),x=E+1+a*u;d.push(_,D,x),d.push(D,S,x)}this.setIndex(d),this.setAttribute("position",new Ee(m,3)),this.setAttribute("normal",new Ee(C,3)),this.setAttribute("uv",new Ee(f,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new A(t.width,t.height,t.widthSegments,t.heightSegments)}};function sA(A){let t={};for(let e in A){t[e]={};for(let n in A[e]){let i=A[e][n];if(Qa(i))i.isRenderTargetTexture?(yt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=i.clone();else if(Array.isArray(i))if(Qa(i[0])){let s=[];for(let r=0,o=i.length;r<o;r++)s[r]=i[r].clone();t[e][n]=s}else t[e][n]=i.slice();else t[e][n]=i}}return t}function ye(A){let t={};for(let e=0;e<A.length;e++){let n=sA(A[e]);for(let i in n)t[i]=n[i]}return t}function Qa(A){return A&&(A.isColor||A.isMatrix3||A.isMatrix4||A.isVector2||A.isVector3||A.isVector4||A.isTexture||A.isQuaternion)}function Pl(A){let t=[];for(let e=0;e<A.length;e++)t.push(A[e].clone());return t}function Uo(A){let t=A.getRenderTarget();return t===null?A.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:kt.workingColorSpace}var Ec={clone:sA,merge:ye},Fl=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ul=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ln=class extends xn{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Fl,this.fragmentShader=Ul,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=sA(t.uniforms),this.uniformsGroups=Pl(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let i in this.uniforms){let r=this.uniforms[i].value;r&&r.isTexture?e.uniforms[i]={type:"t",value:r.toJSON(t).uuid}:r&&r.isColor?e.uniforms[i]={type:"c",value:r.getHex()}:r&&r.isVector2?e.uniforms[i]={type:"v2",value:r.toArray()}:r&&r.isVector3?e.uniforms[i]={type:"v3",value:r.toArray()}:r&&r.isVector4?e.uniforms[i]={type:"v4",value:r.toArray()}:r&&r.isMatrix3?e.uniforms[i]={type:"m3",value:r.toArray()}:r&&r.isMatrix4?e.uniforms[i]={type:"m4",value:r.toArray()}:e.uniforms[i]={value:r}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let i in this.extensions)this.extensions[i]===!0&&(n[i]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let i=t.uniforms[n];switch(this.uniforms[n]={},i.type){case"t":this.uniforms[n].value=e[i.value]||null;break;case"c":this.uniforms[n].value=new It().setHex(i.value);break;case"v2":this.uniforms[n].value=new Vt().fromArray(i.value);break;case"v3":this.uniforms[n].value=new R().fromArray(i.value);break;case"v4":this.uniforms[n].value=new Ae().fromArray(i.value);break;case"m3":this.uniforms[n].value=new bt().fromArray(i.value);break;case"m4":this.uniforms[n].value=new te().fromArray(i.value);break;default:this.uniforms[n].value=i.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Bs=class extends ln{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var tA=class extends xn{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new It(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new It(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=wr,this.normalScale=new Vt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Dn,this.combine=Ps,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},ws=class extends xn{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=rc,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Cs=class extends xn{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function pA(A,t){return!A||A.constructor===t?A:typeof t.BYTES_PER_ELEMENT=="number"?new t(A):Array.prototype.slice.call(A)}function Ji(A){return A!==void 0&&A.inTangents!==void 0&&A.outTangents!==void 0}var On=class{constructor(t,e,n,i){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=i!==void 0?i:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,i=e[n],s=e[n-1];n:{t:{let r;e:{A:if(!(t<i)){for(let o=n+2;;){if(i===void 0){if(t<s)break A;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===o)break;if(s=i,i=e[++n],t<i)break t}r=e.length;break e}if(!(t>=s)){let o=e[1];t<o&&(n=2,s=o);for(let c=n-2;;){if(s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(i=s,s=e[--n-1],t>=s)break t}r=n,n=0;break e}break n}for(;n<r;){let o=n+r>>>1;t<e[o]?r=o:n=o+1}if(i=e[n],s=e[n-1],s===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,s,i)}return this.interpolate_(n,s,t,i)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,i=this.valueSize,s=t*i;for(let r=0;r!==i;++r)e[r]=n[s+r];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Es=class extends On{constructor(t,e,n,i){super(t,e,n,i),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:eo,endingEnd:eo}}intervalChanged_(t,e,n){let i=this.parameterPositions,s=t-2,r=t+1,o=i[s],c=i[r];if(o===void 0)switch(this.getSettings_().endingStart){case no:s=t,o=2*e-n;break;case Ao:s=i.length-2,o=e+i[s]-i[s+1];break;default:s=t,o=n}if(c===void 0)switch(this.getSettings_().endingEnd){case no:r=t,c=2*n-e;break;case Ao:r=1,c=n+i[1]-i[0];break;default:r=t-1,c=e}let a=(n-e)*.5,l=this.valueSize;this._weightPrev=a/(e-o),this._weightNext=a/(c-n),this._offsetPrev=s*l,this._offsetNext=r*l}interpolate_(t,e,n,i){let s=this.resultBuffer,r=this.sampleValues,o=this.valueSize,c=t*o,a=c-o,l=this._offsetPrev,g=this._offsetNext,h=this._weightPrev,d=this._weightNext,m=(n-e)/(i-e),C=m*m,f=C*m,u=-h*f+2*h*C-h*m,E=(1+h)*f+(-1.5-2*h)*C+(-.5+h)*m+1,_=(-1-d)*f+(1.5+d)*C+.5*m,D=d*f-d*C;for(let S=0;S!==o;++S)s[S]=u*r[l+S]+E*r[a+S]+_*r[c+S]+D*r[g+S];return s}},Ms=class extends On{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t,e,n,i){let s=this.resultBuffer,r=this.sampleValues,o=this.valueSize,c=t*o,a=c-o,l=(n-e)/(i-e),g=1-l;for(let h=0;h!==o;++h)s[h]=r[a+h]*g+r[c+h]*l;return s}},vs=class extends On{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t){return this.copySampleValue_(t-1)}},Ds=class extends On{interpolate_(t,e,n,i){let s=this.resultBuffer,r=this.sampleValues,o=this.valueSize,c=t*o,a=c-o,l=this.inTangents,g=this.outTangents;if(!l||!g){let m=(n-e)/(i-e),C=1-m;for(let f=0;f!==o;++f)s[f]=r[a+f]*C+r[c+f]*m;return s}let h=o*2,d=t-1;for(let m=0;m!==o;++m){let C=r[a+m],f=r[c+m],u=d*h+m*2,E=g[u],_=g[u+1],D=t*h+m*2,S=l[D],x=l[D+1],p=Ll(n,e,E,S,i);s[m]=Mc(p,C,_,x,f)}return s}};function Mc(A,t,e,n,i){let s=1-A;return s*s*s*t+3*s*s*A*e+3*s*A*A*n+A*A*A*i}function Rl(A,t,e,n,i){let s=1-A;return 3*s*s*(e-t)+6*s*A*(n-e)+3*A*A*(i-n)}function Ll(A,t,e,n,i){let s=(A-t)/(i-t);for(let r=0;r<8;r++){let o=Mc(s,t,e,n,i)-A;if(Math.abs(o)<1e-10)break;let c=Rl(s,t,e,n,i);if(Math.abs(c)<1e-10)break;s=Math.max(0,Math.min(1,s-o/c))}return s}var ze=class{constructor(t,e,n,i){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=pA(e,this.TimeBufferType),this.values=pA(n,this.ValueBufferType),this.setInterpolation(i||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:pA(t.times,Array),values:pA(t.values,Array)};let i=t.getInterpolation();i!==t.DefaultInterpolation&&(n.interpolation=i),Ji(t.settings)&&(n.settings={inTangents:pA(t.settings.inTangents,Array),outTangents:pA(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new vs(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Ms(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Es(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Ds(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case GA:e=this.InterpolantFactoryMethodDiscrete;break;case os:e=this.InterpolantFactoryMethodLinear;break;case Xi:e=this.InterpolantFactoryMethodSmooth;break;case to:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return yt("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return GA;case this.InterpolantFactoryMethodLinear:return os;case this.InterpolantFactoryMethodSmooth:return Xi;case this.InterpolantFactoryMethodBezier:return to}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,i=e.length;n!==i;++n)e[n]+=t;Ji(this.settings)&&(Ia(this.settings.inTangents,t),Ia(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,i=e.length;n!==i;++n)e[n]*=t;Ji(this.settings)&&(ba(this.settings.inTangents,t),ba(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,i=n.length,s=0,r=i-1;for(;s!==i&&n[s]<t;)++s;for(;r!==-1&&n[r]>e;)--r;if(++r,s!==0||r!==i){s>=r&&(r=Math.max(r,1),s=r-1);let o=this.getValueSize();this.times=n.slice(s,r),this.values=this.values.slice(s*o,r*o)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Qt("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,i=this.values,s=n.length;s===0&&(Qt("KeyframeTrack: Track is empty.",this),t=!1);let r=null;for(let o=0;o!==s;o++){let c=n[o];if(typeof c=="number"&&isNaN(c)){Qt("KeyframeTrack: Time is not a valid number.",this,o,c),t=!1;break}if(r!==null&&r>c){Qt("KeyframeTrack: Out of order keys.",this,o,c,r),t=!1;break}r=c}if(i!==void 0&&hl(i))for(let o=0,c=i.length;o!==c;++o){let a=i[o];if(isNaN(a)){Qt("KeyframeTrack: Value is not a valid number.",this,o,a),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),i=this.getInterpolation()===Xi,s=t.length-1,r=1;for(let o=1;o<s;++o){let c=!1,a=t[o],l=t[o+1];if(a!==l&&(o!==1||a!==t[0]))if(i)c=!0;else{let g=o*n,h=g-n,d=g+n;for(let m=0;m!==n;++m){let C=e[g+m];if(C!==e[h+m]||C!==e[d+m]){c=!0;break}}}if(c){if(o!==r){t[r]=t[o];let g=o*n,h=r*n;for(let d=0;d!==n;++d)e[h+d]=e[g+d]}++r}}if(s>0){t[r]=t[s];for(let o=s*n,c=r*n,a=0;a!==n;++a)e[c+a]=e[o+a];++r}return r!==t.length?(this.times=t.slice(0,r),this.values=e.slice(0,r*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,i=new n(this.name,t,e);return i.createInterpolant=this.createInterpolant,Ji(this.settings)&&(i.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),i}};function Ia(A,t){for(let e=0,n=A.length;e!==n;e+=2)A[e]+=t}function ba(A,t){for(let e=0,n=A.length;e!==n;e+=2)A[e]*=t}ze.prototype.ValueTypeName="";ze.prototype.TimeBufferType=Float32Array;ze.prototype.ValueBufferType=Float32Array;ze.prototype.DefaultInterpolation=os;var Gn=class extends ze{constructor(t,e,n){super(t,e,n)}};Gn.prototype.ValueTypeName="bool";Gn.prototype.ValueBufferType=Array;Gn.prototype.DefaultInterpolation=GA;Gn.prototype.InterpolantFactoryMethodLinear=void 0;Gn.prototype.InterpolantFactoryMethodSmooth=void 0;var xs=class extends ze{constructor(t,e,n,i){super(t,e,n,i)}};xs.prototype.ValueTypeName="color";var _s=class extends ze{constructor(t,e,n,i){super(t,e,n,i)}};_s.prototype.ValueTypeName="number";var ys=class extends On{constructor(t,e,n,i){super(t,e,n,i)}interpolate_(t,e,n,i){let s=this.resultBuffer,r=this.sampleValues,o=this.valueSize,c=(n-e)/(i-e),a=t*o;for(let l=a+o;a!==l;a+=4)Oe.slerpFlat(s,0,r,a-o,r,a,c);return s}},ni=class extends ze{constructor(t,e,n,i){super(t,e,n,i)}InterpolantFactoryMethodLinear(t){return new ys(this.times,this.values,this.getValueSize(),t)}};ni.prototype.ValueTypeName="quaternion";ni.prototype.InterpolantFactoryMethodSmooth=void 0;var kn=class extends ze{constructor(t,e,n){super(t,e,n)}};kn.prototype.ValueTypeName="string";kn.prototype.ValueBufferType=Array;kn.prototype.DefaultInterpolation=GA;kn.prototype.InterpolantFactoryMethodLinear=void 0;kn.prototype.InterpolantFactoryMethodSmooth=void 0;var Ss=class extends ze{constructor(t,e,n,i){super(t,e,n,i)}};Ss.prototype.ValueTypeName="vector";var Qs=class{constructor(t,e,n){let i=this,s=!1,r=0,o=0,c,a=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(l){o++,s===!1&&i.onStart!==void 0&&i.onStart(l,r,o),s=!0},this.itemEnd=function(l){r++,i.onProgress!==void 0&&i.onProgress(l,r,o),r===o&&(s=!1,i.onLoad!==void 0&&i.onLoad())},this.itemError=function(l){i.onError!==void 0&&i.onError(l)},this.resolveURL=function(l){return l=l.normalize("NFC"),c?c(l):l},this.setURLModifier=function(l){return c=l,this},this.addHandler=function(l,g){return a.push(l,g),this},this.removeHandler=function(l){let g=a.indexOf(l);return g!==-1&&a.splice(g,2),this},this.getHandler=function(l){for(let g=0,h=a.length;g<h;g+=2){let d=a[g],m=a[g+1];if(d.global&&(d.lastIndex=0),d.test(l))return m}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},vc=new Qs,Is=class{constructor(t){this.manager=t!==void 0?t:vc,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(i,s){n.load(t,i,e,s)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Is.DEFAULT_MATERIAL_NAME="__DEFAULT";var Ai=class extends Me{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new It(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},ii=class extends Ai{constructor(t,e,n){super(t,n),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Me.DEFAULT_UP),this.updateMatrix(),this.groundColor=new It(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},$r=new te,Ta=new R,Pa=new R,bs=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Vt(512,512),this.mapType=Ue,this.map=null,this.mapPass=null,this.matrix=new te,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Nn,this._frameExtents=new Vt(1,1),this._viewportCount=1,this._viewports=[new Ae(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Ta.setFromMatrixPosition(t.matrixWorld),e.position.copy(Ta),Pa.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Pa),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,i){$r.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix($r,t.coordinateSystem,t.reversedDepth);let s=this._frameExtents,r=i?i.z/s.x:1,o=i?i.w/s.y:1,c=i?i.x/s.x:0,a=i?i.y/s.y:0;t.coordinateSystem===EA||t.reversedDepth?e.set(.5*r,0,0,.5*r+c,0,.5*o,0,.5*o+a,0,0,1,0,0,0,0,1):e.set(.5*r,0,0,.5*r+c,0,.5*o,0,.5*o+a,0,0,.5,.5,0,0,0,1),e.multiply($r)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Wi=new R,Ki=new Oe,on=new R,si=class extends Me{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new te,this.projectionMatrix=new te,this.projectionMatrixInverse=new te,this.coordinateSystem=Xe,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Wi,Ki,on),on.x===1&&on.y===1&&on.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Wi,Ki,on.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Wi,Ki,on),on.x===1&&on.y===1&&on.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Wi,Ki,on.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Rn=new R,Fa=new Vt,Ua=new Vt,Qe=class extends si{constructor(t=50,e=1,n=.1,i=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=i,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=as*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Zi*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return as*2*Math.atan(Math.tan(Zi*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Rn.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Rn.x,Rn.y).multiplyScalar(-t/Rn.z),Rn.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Rn.x,Rn.y).multiplyScalar(-t/Rn.z)}getViewSize(t,e){return this.getViewBounds(t,Fa,Ua),e.subVectors(Ua,Fa)}setViewOffset(t,e,n,i,s,r){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=i,this.view.width=s,this.view.height=r,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Zi*.5*this.fov)/this.zoom,n=2*e,i=this.aspect*n,s=-.5*i,r=this.view;if(this.view!==null&&this.view.enabled){let c=r.fullWidth,a=r.fullHeight;s+=r.offsetX*i/c,e-=r.offsetY*n/a,i*=r.width/c,n*=r.height/a}let o=this.filmOffset;o!==0&&(s+=t*o/this.getFilmWidth()),this.projectionMatrix.makePerspective(s,s+i,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var ri=class extends si{constructor(t=-1,e=1,n=1,i=-1,s=.1,r=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=i,this.near=s,this.far=r,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,i,s,r){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=i,this.view.width=s,this.view.height=r,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,i=(this.top+this.bottom)/2,s=n-t,r=n+t,o=i+e,c=i-e;if(this.view!==null&&this.view.enabled){let a=(this.right-this.left)/this.view.fullWidth/this.zoom,l=(this.top-this.bottom)/this.view.fullHeight/this.zoom;s+=a*this.view.offsetX,r=s+a*this.view.width,o-=l*this.view.offsetY,c=o-l*this.view.height}this.projectionMatrix.makeOrthographic(s,r,o,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},io=class extends bs{constructor(){super(new ri(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},oi=class extends Ai{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Me.DEFAULT_UP),this.updateMatrix(),this.target=new Me,this.shadow=new io}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var mA=-90,BA=1,_A=class extends Me{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let i=new Qe(mA,BA,t,e);i.layers=this.layers,this.add(i);let s=new Qe(mA,BA,t,e);s.layers=this.layers,this.add(s);let r=new Qe(mA,BA,t,e);r.layers=this.layers,this.add(r);let o=new Qe(mA,BA,t,e);o.layers=this.layers,this.add(o);let c=new Qe(mA,BA,t,e);c.layers=this.layers,this.add(c);let a=new Qe(mA,BA,t,e);a.layers=this.layers,this.add(a)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,i,s,r,o,c]=e;for(let a of e)this.remove(a);if(t===Xe)n.up.set(0,1,0),n.lookAt(1,0,0),i.up.set(0,1,0),i.lookAt(-1,0,0),s.up.set(0,0,-1),s.lookAt(0,1,0),r.up.set(0,0,1),r.lookAt(0,-1,0),o.up.set(0,1,0),o.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===EA)n.up.set(0,-1,0),n.lookAt(-1,0,0),i.up.set(0,-1,0),i.lookAt(1,0,0),s.up.set(0,0,1),s.lookAt(0,1,0),r.up.set(0,0,-1),r.lookAt(0,-1,0),o.up.set(0,-1,0),o.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let a of e)this.add(a),a.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:i}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[s,r,o,c,a,l]=this.children,g=t.getRenderTarget(),h=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),m=t.xr.enabled;t.xr.enabled=!1;let C=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let f=!1;t.isWebGLRenderer===!0?f=t.state.buffers.depth.getReversed():f=t.reversedDepthBuffer,t.setRenderTarget(n,0,i),f&&t.autoClear===!1&&t.clearDepth(),t.render(e,s),t.setRenderTarget(n,1,i),f&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,2,i),f&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,3,i),f&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,i),f&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),n.texture.mipmapsAutoUpdate=C,t.setRenderTarget(n,5,i),f&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(g,h,d),t.xr.enabled=m,n.texture.needsPMREMUpdate=!0}},Ts=class extends Qe{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Ro="\\[\\]\\.:\\/",Nl=new RegExp("["+Ro+"]","g"),Lo="[^"+Ro+"]",Hl="[^"+Ro.replace("\\.","")+"]",Ol=/((?:WC+[\/:])*)/.source.replace("WC",Lo),Gl=/(WCOD+)?/.source.replace("WCOD",Hl),kl=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Lo),zl=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Lo),Vl=new RegExp("^"+Ol+Gl+kl+zl+"$"),Yl=["material","materials","bones","map"],so=class{constructor(t,e,n){let i=n||$t.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,i)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,i=this._bindings[n];i!==void 0&&i.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let i=this._targetGroup.nCachedObjects_,s=n.length;i!==s;++i)n[i].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},$t=class A{constructor(t,e,n){this.path=e,this.parsedPath=n||A.parseTrackName(e),this.node=A.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new A.Composite(t,e,n):new A(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Nl,"")}static parseTrackName(t){let e=Vl.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},i=n.nodeName&&n.nodeName.lastIndexOf(".");if(i!==void 0&&i!==-1){let s=n.nodeName.substring(i+1);Yl.indexOf(s)!==-1&&(n.nodeName=n.nodeName.substring(0,i),n.objectName=s)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(s){for(let r=0;r<s.length;r++){let o=s[r];if(o.name===e||o.uuid===e)return o;let c=n(o.children);if(c)return c}return null},i=n(t.children);if(i)return i}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)t[e++]=n[i]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)n[i]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)n[i]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let i=0,s=n.length;i!==s;++i)n[i]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,i=e.propertyName,s=e.propertyIndex;if(t||(t=A.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){yt("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let a=e.objectIndex;switch(n){case"materials":if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Qt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Qt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let l=0;l<t.length;l++)if(t[l].name===a){a=l;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Qt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Qt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Qt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(a!==void 0){if(t[a]===void 0){Qt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[a]}}let r=t[i];if(r===void 0){let a=e.nodeName;Qt("PropertyBinding: Trying to update property for track: "+a+"."+i+" but it wasn't found.",t);return}let o=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?o=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(o=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(s!==void 0){if(i==="morphTargetInfluences"){if(!t.geometry){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Qt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[s]!==void 0&&(s=t.morphTargetDictionary[s])}c=this.BindingType.ArrayElement,this.resolvedProperty=r,this.propertyIndex=s}else r.fromArray!==void 0&&r.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=r):Array.isArray(r)?(c=this.BindingType.EntireArray,this.resolvedProperty=r):this.propertyName=i;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][o]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};$t.Composite=so;$t.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};$t.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};$t.prototype.GetterByBindingType=[$t.prototype._getValue_direct,$t.prototype._getValue_array,$t.prototype._getValue_arrayElement,$t.prototype._getValue_toArray];$t.prototype.SetterByBindingTypeAndVersioning=[[$t.prototype._setValue_direct,$t.prototype._setValue_direct_setNeedsUpdate,$t.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_array,$t.prototype._setValue_array_setNeedsUpdate,$t.prototype._setValue_array_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_arrayElement,$t.prototype._setValue_arrayElement_setNeedsUpdate,$t.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[$t.prototype._setValue_fromArray,$t.prototype._setValue_fromArray_setNeedsUpdate,$t.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Xg=new Float32Array(1);var ro=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,i){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,i)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,i){let s=this.elements;return s[0]=t,s[2]=e,s[1]=n,s[3]=i,this}};var ai=class extends xA{constructor(t=10,e=10,n=4473924,i=8947848){n=new It(n),i=new It(i);let s=e/2,r=t/e,o=t/2,c=[],a=[];for(let h=0,d=0,m=-o;h<=e;h++,m+=r){c.push(-o,0,m,o,0,m),c.push(m,0,-o,m,0,o);let C=h===s?n:i;C.toArray(a,d),d+=3,C.toArray(a,d),d+=3,C.toArray(a,d),d+=3,C.toArray(a,d),d+=3}let l=new ke;l.setAttribute("position",new Ee(c,3)),l.setAttribute("color",new Ee(a,3));let g=new $n({vertexColors:!0,toneMapped:!1});super(l,g),this.type="GridHelper"}dispose(){super.dispose(),this.geometry.dispose(),this.material.dispose()}};function No(A,t,e,n){let i=Jl(n);switch(e){case _o:return A*t;case So:return A*t/i.components*i.byteLength;case Os:return A*t/i.components*i.byteLength;case Vn:return A*t*2/i.components*i.byteLength;case Gs:return A*t*2/i.components*i.byteLength;case yo:return A*t*3/i.components*i.byteLength;case sn:return A*t*4/i.components*i.byteLength;case ks:return A*t*4/i.components*i.byteLength;case hi:case ui:return Math.floor((A+3)/4)*Math.floor((t+3)/4)*8;case fi:case di:return Math.floor((A+3)/4)*Math.floor((t+3)/4)*16;case Vs:case Js:return Math.max(A,16)*Math.max(t,8)/4;case zs:case Ys:return Math.max(A,8)*Math.max(t,8)/2;case Ws:case Ks:case qs:case Zs:return Math.floor((A+3)/4)*Math.floor((t+3)/4)*8;case Xs:case gi:case js:return Math.floor((A+3)/4)*Math.floor((t+3)/4)*16;case $s:return Math.floor((A+3)/4)*Math.floor((t+3)/4)*16;case tr:return Math.floor((A+4)/5)*Math.floor((t+3)/4)*16;case er:return Math.floor((A+4)/5)*Math.floor((t+4)/5)*16;case nr:return Math.floor((A+5)/6)*Math.floor((t+4)/5)*16;case Ar:return Math.floor((A+5)/6)*Math.floor((t+5)/6)*16;case ir:return Math.floor((A+7)/8)*Math.floor((t+4)/5)*16;case sr:return Math.floor((A+7)/8)*Math.floor((t+5)/6)*16;case rr:return Math.floor((A+7)/8)*Math.floor((t+7)/8)*16;case or:return Math.floor((A+9)/10)*Math.floor((t+4)/5)*16;case ar:return Math.floor((A+9)/10)*Math.floor((t+5)/6)*16;case cr:return Math.floor((A+9)/10)*Math.floor((t+7)/8)*16;case lr:return Math.floor((A+9)/10)*Math.floor((t+9)/10)*16;case hr:return Math.floor((A+11)/12)*Math.floor((t+9)/10)*16;case ur:return Math.floor((A+11)/12)*Math.floor((t+11)/12)*16;case fr:case dr:case gr:return Math.ceil(A/4)*Math.ceil(t/4)*16;case pr:case mr:return Math.ceil(A/4)*Math.ceil(t/4)*8;case pi:case Br:return Math.ceil(A/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Jl(A){switch(A){case Ue:case Mo:return{byteLength:1,components:1};case IA:case vo:case An:return{byteLength:2,components:1};case Ns:case Hs:return{byteLength:2,components:4};case en:case Ls:case nn:return{byteLength:4,components:1};case Do:case xo:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${A}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?yt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");/**
 * @license
 * Copyright 2010-2026 Three.js Authors
 * SPDX-License-Identifier: MIT
 */function Yc(){let A=null,t=!1,e=null,n=null;function i(s,r){n=A.requestAnimationFrame(i),e(s,r)}return{start:function(){t!==!0&&e!==null&&A!==null&&(n=A.requestAnimationFrame(i),t=!0)},stop:function(){A!==null&&A.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(s){e=s},setContext:function(s){A=s}}}function Kl(A){let t=new WeakMap;function e(o,c){let a=o.array,l=o.usage,g=a.byteLength,h=A.createBuffer();A.bindBuffer(c,h),A.bufferData(c,a,l),o.onUploadCallback();let d;if(a instanceof Float32Array)d=A.FLOAT;else if(typeof Float16Array<"u"&&a instanceof Float16Array)d=A.HALF_FLOAT;else if(a instanceof Uint16Array)o.isFloat16BufferAttribute?d=A.HALF_FLOAT:d=A.UNSIGNED_SHORT;else if(a instanceof Int16Array)d=A.SHORT;else if(a instanceof Uint32Array)d=A.UNSIGNED_INT;else if(a instanceof Int32Array)d=A.INT;else if(a instanceof Int8Array)d=A.BYTE;else if(a instanceof Uint8Array)d=A.UNSIGNED_BYTE;else if(a instanceof Uint8ClampedArray)d=A.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+a);return{buffer:h,type:d,bytesPerElement:a.BYTES_PER_ELEMENT,version:o.version,size:g}}function n(o,c,a){let l=c.array,g=c.updateRanges;if(A.bindBuffer(a,o),g.length===0)A.bufferSubData(a,0,l);else{g.sort((d,m)=>d.start-m.start);let h=0;for(let d=1;d<g.length;d++){let m=g[h],C=g[d];C.start<=m.start+m.count+1?m.count=Math.max(m.count,C.start+C.count-m.start):(++h,g[h]=C)}g.length=h+1;for(let d=0,m=g.length;d<m;d++){let C=g[d];A.bufferSubData(a,C.start*l.BYTES_PER_ELEMENT,l,C.start,C.count)}c.clearUpdateRanges()}c.onUploadCallback()}function i(o){return o.isInterleavedBufferAttribute&&(o=o.data),t.get(o)}function s(o){o.isInterleavedBufferAttribute&&(o=o.data);let c=t.get(o);c&&(A.deleteBuffer(c.buffer),t.delete(o))}function r(o,c){if(o.isInterleavedBufferAttribute&&(o=o.data),o.isGLBufferAttribute){let l=t.get(o);(!l||l.version<o.version)&&t.set(o,{buffer:o.buffer,type:o.type,bytesPerElement:o.elementSize,version:o.version});return}let a=t.get(o);if(a===void 0)t.set(o,e(o,c));else if(a.version<o.version){if(a.size!==o.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(a.buffer,o,c),a.version=o.version}}return{get:i,remove:s,update:r}}var Xl=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ql=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Zl=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,jl=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,$l=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,th=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,eh=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,nh=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Ah=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,ih=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,sh=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,rh=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,oh=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,ah=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,ch=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,lh=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,hh=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,uh=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,fh=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,dh=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,gh=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,ph=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,mh=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Bh=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,wh=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,Ch=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Eh=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Mh=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,vh=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Dh="gl_FragColor = linearToOutputTexel( gl_FragColor );",xh=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,_h=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,yh=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Sh=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Qh=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Ih=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,bh=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Th=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Ph=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Fh=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Uh=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Rh=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Lh=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Nh=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Hh=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Oh=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Gh=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,kh=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,zh=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Vh=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Yh=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Jh=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Wh=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Kh=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Xh=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,qh=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Zh=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,jh=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,$h=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,tu=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,eu=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,nu=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Au=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,iu=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,su=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,ru=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,ou=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,au=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,cu=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,lu=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,hu=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,uu=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,fu=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,du=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,gu=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,pu=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,mu=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,Bu=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,wu=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,Cu=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Eu=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Mu=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,vu=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Du=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,xu=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,_u=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,yu=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Su=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Qu=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Iu=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,bu=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Tu=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Pu=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Fu=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Uu=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Ru=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Lu=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Nu=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Hu=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Ou=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Gu=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,ku=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,zu=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Vu=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Yu=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Ju=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Wu=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Ku=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Xu=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qu=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Zu=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ju=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,$u=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,tf=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,ef=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,nf=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Af=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,sf=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,rf=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,of=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,af=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cf=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,lf=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,hf=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,uf=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ff=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,df=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,gf=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,pf=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,mf=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Bf=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,wf=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,Cf=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ef=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Mf=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,vf=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Df=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,xf=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,_f=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,yf=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Sf=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Nt={alphahash_fragment:Xl,alphahash_pars_fragment:ql,alphamap_fragment:Zl,alphamap_pars_fragment:jl,alphatest_fragment:$l,alphatest_pars_fragment:th,aomap_fragment:eh,aomap_pars_fragment:nh,batching_pars_vertex:Ah,batching_vertex:ih,begin_vertex:sh,beginnormal_vertex:rh,bsdfs:oh,iridescence_fragment:ah,bumpmap_pars_fragment:ch,clipping_planes_fragment:lh,clipping_planes_pars_fragment:hh,clipping_planes_pars_vertex:uh,clipping_planes_vertex:fh,color_fragment:dh,color_pars_fragment:gh,color_pars_vertex:ph,color_vertex:mh,common:Bh,defaultnormal_vertex:wh,displacementmap_pars_vertex:Ch,displacementmap_vertex:Eh,emissivemap_fragment:Mh,emissivemap_pars_fragment:vh,colorspace_fragment:Dh,colorspace_pars_fragment:xh,envmap_fragment:_h,envmap_common_pars_fragment:yh,envmap_pars_fragment:Sh,envmap_pars_vertex:Qh,envmap_physical_pars_fragment:Oh,envmap_vertex:Ih,fog_vertex:bh,fog_pars_vertex:Th,fog_fragment:Ph,fog_pars_fragment:Fh,gradientmap_pars_fragment:Uh,lightmap_pars_fragment:Rh,lights_lambert_fragment:Lh,lights_lambert_pars_fragment:Nh,lights_pars_begin:Hh,lights_toon_fragment:Gh,lights_toon_pars_fragment:kh,lights_phong_fragment:zh,lights_phong_pars_fragment:Vh,lights_physical_fragment:Yh,lights_physical_pars_fragment:Jh,lights_fragment_begin:Wh,lights_fragment_maps:Kh,lights_fragment_end:Xh,lightprobes_pars_fragment:qh,logdepthbuf_fragment:Zh,logdepthbuf_pars_fragment:jh,logdepthbuf_pars_vertex:$h,logdepthbuf_vertex:tu,map_fragment:eu,map_pars_fragment:nu,map_particle_fragment:Au,map_particle_pars_fragment:iu,metalnessmap_fragment:su,metalnessmap_pars_fragment:ru,morphinstance_vertex:ou,morphcolor_vertex:au,morphnormal_vertex:cu,morphtarget_pars_vertex:lu,morphtarget_vertex:hu,normal_fragment_begin:uu,normal_fragment_maps:fu,normal_pars_fragment:du,normal_pars_vertex:gu,normal_vertex:pu,normalmap_pars_fragment:mu,clearcoat_normal_fragment_begin:Bu,clearcoat_normal_fragment_maps:wu,clearcoat_pars_fragment:Cu,iridescence_pars_fragment:Eu,opaque_fragment:Mu,packing:vu,premultiplied_alpha_fragment:Du,project_vertex:xu,dithering_fragment:_u,dithering_pars_fragment:yu,roughnessmap_fragment:Su,roughnessmap_pars_fragment:Qu,shadowmap_pars_fragment:Iu,shadowmap_pars_vertex:bu,shadowmap_vertex:Tu,shadowmask_pars_fragment:Pu,skinbase_vertex:Fu,skinning_pars_vertex:Uu,skinning_vertex:Ru,skinnormal_vertex:Lu,specularmap_fragment:Nu,specularmap_pars_fragment:Hu,tonemapping_fragment:Ou,tonemapping_pars_fragment:Gu,transmission_fragment:ku,transmission_pars_fragment:zu,uv_pars_fragment:Vu,uv_pars_vertex:Yu,uv_vertex:Ju,worldpos_vertex:Wu,background_vert:Ku,background_frag:Xu,backgroundCube_vert:qu,backgroundCube_frag:Zu,cube_vert:ju,cube_frag:$u,depth_vert:tf,depth_frag:ef,distance_vert:nf,distance_frag:Af,equirect_vert:sf,equirect_frag:rf,linedashed_vert:of,linedashed_frag:af,meshbasic_vert:cf,meshbasic_frag:lf,meshlambert_vert:hf,meshlambert_frag:uf,meshmatcap_vert:ff,meshmatcap_frag:df,meshnormal_vert:gf,meshnormal_frag:pf,meshphong_vert:mf,meshphong_frag:Bf,meshphysical_vert:wf,meshphysical_frag:Cf,meshtoon_vert:Ef,meshtoon_frag:Mf,points_vert:vf,points_frag:Df,shadow_vert:xf,shadow_frag:_f,sprite_vert:yf,sprite_frag:Sf},ft={common:{diffuse:{value:new It(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new bt},alphaMap:{value:null},alphaMapTransform:{value:new bt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new bt}},envmap:{envMap:{value:null},envMapRotation:{value:new bt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new bt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new bt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new bt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new bt},normalScale:{value:new Vt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new bt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new bt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new bt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new bt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new It(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new It(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new bt},alphaTest:{value:0},uvTransform:{value:new bt}},sprite:{diffuse:{value:new It(16777215)},opacity:{value:1},center:{value:new Vt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new bt},alphaMap:{value:null},alphaMapTransform:{value:new bt},alphaTest:{value:0}}},dn={basic:{uniforms:ye([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:Nt.meshbasic_vert,fragmentShader:Nt.meshbasic_frag},lambert:{uniforms:ye([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new It(0)},envMapIntensity:{value:1}}]),vertexShader:Nt.meshlambert_vert,fragmentShader:Nt.meshlambert_frag},phong:{uniforms:ye([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new It(0)},specular:{value:new It(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Nt.meshphong_vert,fragmentShader:Nt.meshphong_frag},standard:{uniforms:ye([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new It(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Nt.meshphysical_vert,fragmentShader:Nt.meshphysical_frag},toon:{uniforms:ye([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new It(0)}}]),vertexShader:Nt.meshtoon_vert,fragmentShader:Nt.meshtoon_frag},matcap:{uniforms:ye([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:Nt.meshmatcap_vert,fragmentShader:Nt.meshmatcap_frag},points:{uniforms:ye([ft.points,ft.fog]),vertexShader:Nt.points_vert,fragmentShader:Nt.points_frag},dashed:{uniforms:ye([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Nt.linedashed_vert,fragmentShader:Nt.linedashed_frag},depth:{uniforms:ye([ft.common,ft.displacementmap]),vertexShader:Nt.depth_vert,fragmentShader:Nt.depth_frag},normal:{uniforms:ye([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:Nt.meshnormal_vert,fragmentShader:Nt.meshnormal_frag},sprite:{uniforms:ye([ft.sprite,ft.fog]),vertexShader:Nt.sprite_vert,fragmentShader:Nt.sprite_frag},background:{uniforms:{uvTransform:{value:new bt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Nt.background_vert,fragmentShader:Nt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new bt}},vertexShader:Nt.backgroundCube_vert,fragmentShader:Nt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Nt.cube_vert,fragmentShader:Nt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Nt.equirect_vert,fragmentShader:Nt.equirect_frag},distance:{uniforms:ye([ft.common,ft.displacementmap,{referencePosition:{value:new R},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Nt.distance_vert,fragmentShader:Nt.distance_frag},shadow:{uniforms:ye([ft.lights,ft.fog,{color:{value:new It(0)},opacity:{value:1}}]),vertexShader:Nt.shadow_vert,fragmentShader:Nt.shadow_frag}};dn.physical={uniforms:ye([dn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new bt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new bt},clearcoatNormalScale:{value:new Vt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new bt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new bt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new bt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new bt},sheen:{value:0},sheenColor:{value:new It(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new bt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new bt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new bt},transmissionSamplerSize:{value:new Vt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new bt},attenuationDistance:{value:0},attenuationColor:{value:new It(0)},specularColor:{value:new It(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new bt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new bt},anisotropyVector:{value:new Vt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new bt}}]),vertexShader:Nt.meshphysical_vert,fragmentShader:Nt.meshphysical_frag};var Cr={r:0,b:0,g:0},Qf=new te,Jc=new bt;Jc.set(-1,0,0,0,1,0,0,0,1);function If(A,t,e,n,i,s){let r=new It(0),o=i===!0?0:1,c,a,l=null,g=0,h=null;function d(E){let _=E.isScene===!0?E.background:null;if(_&&_.isTexture){let D=E.backgroundBlurriness>0;_=t.get(_,D)}return _}function m(E){let _=!1,D=d(E);D===null?f(r,o):D&&D.isColor&&(f(D,1),_=!0);let S=A.xr.getEnvironmentBlendMode();S==="additive"?e.buffers.color.setClear(0,0,0,1,s):S==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,s),(A.autoClear||_)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),A.clear(A.autoClearColor,A.autoClearDepth,A.autoClearStencil))}function C(E,_){let D=d(_);D&&D.isCubeTexture?(a===void 0&&(a=new Fe(new Hn(1,1,1),new ln({name:"BackgroundCubeMaterial",uniforms:sA(dn.backgroundCube.uniforms),vertexShader:dn.backgroundCube.vertexShader,fragmentShader:dn.backgroundCube.fragmentShader,side:be,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),a.geometry.deleteAttribute("normal"),a.geometry.deleteAttribute("uv"),a.onBeforeRender=function(S,x,p){this.matrixWorld.copyPosition(p.matrixWorld)},Object.defineProperty(a.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(a)),a.material.uniforms.envMap.value=D,a.material.uniforms.backgroundBlurriness.value=_.backgroundBlurriness,a.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,a.material.uniforms.backgroundRotation.value.setFromMatrix4(Qf.makeRotationFromEuler(_.backgroundRotation)).transpose(),D.isRenderTargetTexture===!1&&a.material.uniforms.backgroundRotation.value.premultiply(Jc),a.material.toneMapped=kt.getTransfer(D.colorSpace)!==Wt,(l!==D||g!==D.version||h!==A.toneMapping)&&(a.material.needsUpdate=!0,l=D,g=D.version,h=A.toneMapping),a.layers.enableAll(),E.unshift(a,a.geometry,a.material,0,0,null)):D&&D.isTexture&&(c===void 0&&(c=new Fe(new ei(2,2),new ln({name:"BackgroundMaterial",uniforms:sA(dn.background.uniforms),vertexShader:dn.background.vertexShader,fragmentShader:dn.background.fragmentShader,side:zn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=D,c.material.uniforms.backgroundIntensity.value=_.backgroundIntensity,c.material.toneMapped=kt.getTransfer(D.colorSpace)!==Wt,D.matrixAutoUpdate===!0&&D.updateMatrix(),c.material.uniforms.uvTransform.value.copy(D.matrix),(l!==D||g!==D.version||h!==A.toneMapping)&&(c.material.needsUpdate=!0,l=D,g=D.version,h=A.toneMapping),c.layers.enableAll(),E.unshift(c,c.geometry,c.material,0,0,null))}function f(E,_){E.getRGB(Cr,Uo(A)),e.buffers.color.setClear(Cr.r,Cr.g,Cr.b,_,s)}function u(){a!==void 0&&(a.geometry.dispose(),a.material.dispose(),a=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return r},setClearColor:function(E,_=1){r.set(E),o=_,f(r,o)},getClearAlpha:function(){return o},setClearAlpha:function(E){o=E,f(r,o)},render:m,addToRenderList:C,dispose:u}}function bf(A,t){let e=A.getParameter(A.MAX_VERTEX_ATTRIBS),n={},i=h(null),s=i,r=!1;function o(P,O,J,I,V){let q=!1,G=g(P,I,J,O);s!==G&&(s=G,a(s.object)),q=d(P,I,J,V),q&&m(P,I,J,V),V!==null&&t.update(V,A.ELEMENT_ARRAY_BUFFER),(q||r)&&(r=!1,D(P,O,J,I),V!==null&&A.bindBuffer(A.ELEMENT_ARRAY_BUFFER,t.get(V).buffer))}function c(){return A.createVertexArray()}function a(P){return A.bindVertexArray(P)}function l(P){return A.deleteVertexArray(P)}function g(P,O,J,I){let V=I.wireframe===!0,q=n[O.id];q===void 0&&(q={},n[O.id]=q);let G=P.isInstancedMesh===!0?P.id:0,et=q[G];et===void 0&&(et={},q[G]=et);let z=et[J.id];z===void 0&&(z={},et[J.id]=z);let j=z[V];return j===void 0&&(j=h(c()),z[V]=j),j}function h(P){let O=[],J=[],I=[];for(let V=0;V<e;V++)O[V]=0,J[V]=0,I[V]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:O,enabledAttributes:J,attributeDivisors:I,object:P,attributes:{},index:null}}function d(P,O,J,I){let V=s.attributes,q=O.attributes,G=0,et=J.getAttributes();for(let z in et)if(et[z].location>=0){let $=V[z],Et=q[z];if(Et===void 0&&(z==="instanceMatrix"&&P.instanceMatrix&&(Et=P.instanceMatrix),z==="instanceColor"&&P.instanceColor&&(Et=P.instanceColor)),$===void 0||$.attribute!==Et||Et&&$.data!==Et.data)return!0;G++}return s.attributesNum!==G||s.index!==I}function m(P,O,J,I){let V={},q=O.attributes,G=0,et=J.getAttributes();for(let z in et)if(et[z].location>=0){let $=q[z];$===void 0&&(z==="instanceMatrix"&&P.instanceMatrix&&($=P.instanceMatrix),z==="instanceColor"&&P.instanceColor&&($=P.instanceColor));let Et={};Et.attribute=$,$&&$.data&&(Et.data=$.data),V[z]=Et,G++}s.attributes=V,s.attributesNum=G,s.index=I}function C(){let P=s.newAttributes;for(let O=0,J=P.length;O<J;O++)P[O]=0}function f(P){u(P,0)}function u(P,O){let J=s.newAttributes,I=s.enabledAttributes,V=s.attributeDivisors;J[P]=1,I[P]===0&&(A.enableVertexAttribArray(P),I[P]=1),V[P]!==O&&(A.vertexAttribDivisor(P,O),V[P]=O)}function E(){let P=s.newAttributes,O=s.enabledAttributes;for(let J=0,I=O.length;J<I;J++)O[J]!==P[J]&&(A.disableVertexAttribArray(J),O[J]=0)}function _(P,O,J,I,V,q,G){G===!0?A.vertexAttribIPointer(P,O,J,V,q):A.vertexAttribPointer(P,O,J,I,V,q)}function D(P,O,J,I){C();let V=I.attributes,q=J.getAttributes(),G=O.defaultAttributeValues;for(let et in q){let z=q[et];if(z.location>=0){let j=V[et];if(j===void 0&&(et==="instanceMatrix"&&P.instanceMatrix&&(j=P.instanceMatrix),et==="instanceColor"&&P.instanceColor&&(j=P.instanceColor)),j!==void 0){let $=j.normalized,Et=j.itemSize,Pt=t.get(j);if(Pt===void 0)continue;let K=Pt.buffer,dt=Pt.type,Bt=Pt.bytesPerElement,xt=dt===A.INT||dt===A.UNSIGNED_INT||j.gpuType===Ls;if(j.isInterleavedBufferAttribute){let gt=j.data,Ut=gt.isInterleavedBuffer===!0?gt.stride:gt.itemSize,re=j.offset;if(gt.isInstancedInterleavedBuffer||gt.isInstancedBufferAttribute){for(let St=0;St<z.locationSize;St++)u(z.location+St,gt.meshPerAttribute);P.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=gt.meshPerAttribute*gt.count)}else for(let St=0;St<z.locationSize;St++)f(z.location+St);A.bindBuffer(A.ARRAY_BUFFER,K);for(let St=0;St<z.locationSize;St++)_(z.location+St,Et/z.locationSize,dt,$,Ut*Bt,(re+Et/z.locationSize*St)*Bt,xt)}else{if(j.isInstancedBufferAttribute){for(let gt=0;gt<z.locationSize;gt++)u(z.location+gt,j.meshPerAttribute);P.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=j.meshPerAttribute*j.count)}else for(let gt=0;gt<z.locationSize;gt++)f(z.location+gt);A.bindBuffer(A.ARRAY_BUFFER,K);for(let gt=0;gt<z.locationSize;gt++)_(z.location+gt,Et/z.locationSize,dt,$,Et*Bt,Et/z.locationSize*gt*Bt,xt)}}else if(G!==void 0){let $=G[et];if($!==void 0)switch($.length){case 2:A.vertexAttrib2fv(z.location,$);break;case 3:A.vertexAttrib3fv(z.location,$);break;case 4:A.vertexAttrib4fv(z.location,$);break;default:A.vertexAttrib1fv(z.location,$)}}}}E()}function S(){N();for(let P in n){let O=n[P];for(let J in O){let I=O[J];for(let V in I){let q=I[V];for(let G in q)l(q[G].object),delete q[G];delete I[V]}}delete n[P]}}function x(P){if(n[P.id]===void 0)return;let O=n[P.id];for(let J in O){let I=O[J];for(let V in I){let q=I[V];for(let G in q)l(q[G].object),delete q[G];delete I[V]}}delete n[P.id]}function p(P){for(let O in n){let J=n[O];for(let I in J){let V=J[I];if(V[P.id]===void 0)continue;let q=V[P.id];for(let G in q)l(q[G].object),delete q[G];delete V[P.id]}}}function v(P){for(let O in n){let J=n[O],I=P.isInstancedMesh===!0?P.id:0,V=J[I];if(V!==void 0){for(let q in V){let G=V[q];for(let et in G)l(G[et].object),delete G[et];delete V[q]}delete J[I],Object.keys(J).length===0&&delete n[O]}}}function N(){b(),r=!0,s!==i&&(s=i,a(s.object))}function b(){i.geometry=null,i.program=null,i.wireframe=!1}return{setup:o,reset:N,resetDefaultState:b,dispose:S,releaseStatesOfGeometry:x,releaseStatesOfObject:v,releaseStatesOfProgram:p,initAttributes:C,enableAttribute:f,disableUnusedAttributes:E}}function Tf(A,t,e){let n;function i(c){n=c}function s(c,a){A.drawArrays(n,c,a),e.update(a,n,1)}function r(c,a,l){l!==0&&(A.drawArraysInstanced(n,c,a,l),e.update(a,n,l))}function o(c,a,l){if(l===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,a,0,l);let h=0;for(let d=0;d<l;d++)h+=a[d];e.update(h,n,1)}this.setMode=i,this.render=s,this.renderInstances=r,this.renderMultiDraw=o}function Pf(A,t,e,n){let i;function s(){if(i!==void 0)return i;if(t.has("EXT_texture_filter_anisotropic")===!0){let p=t.get("EXT_texture_filter_anisotropic");i=A.getParameter(p.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else i=0;return i}function r(p){return!(p!==sn&&n.convert(p)!==A.getParameter(A.IMPLEMENTATION_COLOR_READ_FORMAT))}function o(p){let v=p===An&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(p!==Ue&&p!==nn&&!v&&n.convert(p)!==A.getParameter(A.IMPLEMENTATION_COLOR_READ_TYPE))}function c(p){if(p==="highp"){if(A.getShaderPrecisionFormat(A.VERTEX_SHADER,A.HIGH_FLOAT).precision>0&&A.getShaderPrecisionFormat(A.FRAGMENT_SHADER,A.HIGH_FLOAT).precision>0)return"highp";p="mediump"}return p==="mediump"&&A.getShaderPrecisionFormat(A.VERTEX_SHADER,A.MEDIUM_FLOAT).precision>0&&A.getShaderPrecisionFormat(A.FRAGMENT_SHADER,A.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let a=e.precision!==void 0?e.precision:"highp",l=c(a);l!==a&&(yt("WebGLRenderer:",a,"not supported, using",l,"instead."),a=l);let g=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),h=e.logarithmicDepthBuffer===!0&&g===!1;e.reversedDepthBuffer===!0&&g===!1&&yt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&g===!0&&yt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=A.getParameter(A.MAX_TEXTURE_IMAGE_UNITS),m=A.getParameter(A.MAX_VERTEX_TEXTURE_IMAGE_UNITS),C=A.getParameter(A.MAX_TEXTURE_SIZE),f=A.getParameter(A.MAX_CUBE_MAP_TEXTURE_SIZE),u=A.getParameter(A.MAX_VERTEX_ATTRIBS),E=A.getParameter(A.MAX_VERTEX_UNIFORM_VECTORS),_=A.getParameter(A.MAX_VARYING_VECTORS),D=A.getParameter(A.MAX_FRAGMENT_UNIFORM_VECTORS),S=A.getParameter(A.MAX_SAMPLES),x=A.getParameter(A.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:s,getMaxPrecision:c,textureFormatReadable:r,textureTypeReadable:o,precision:a,logarithmicDepthBuffer:h,reversedDepthBuffer:g,maxTextures:d,maxVertexTextures:m,maxTextureSize:C,maxCubemapSize:f,maxAttributes:u,maxVertexUniforms:E,maxVaryings:_,maxFragmentUniforms:D,maxSamples:S,samples:x}}function Ff(A){let t=this,e=null,n=0,i=!1,s=!1,r=new tn,o=new bt,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(g,h){let d=g.length!==0||h||n!==0||i;return i=h,n=g.length,d},this.beginShadows=function(){s=!0,l(null)},this.endShadows=function(){s=!1},this.setGlobalState=function(g,h){e=l(g,h,0)},this.setState=function(g,h,d){let m=g.clippingPlanes,C=g.clipIntersection,f=g.clipShadows,u=A.get(g);if(!i||m===null||m.length===0||s&&!f)s?l(null):a();else{let E=s?0:n,_=E*4,D=u.clippingState||null;c.value=D,D=l(m,h,_,d);for(let S=0;S!==_;++S)D[S]=e[S];u.clippingState=D,this.numIntersection=C?this.numPlanes:0,this.numPlanes+=E}};function a(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function l(g,h,d,m){let C=g!==null?g.length:0,f=null;if(C!==0){if(f=c.value,m!==!0||f===null){let u=d+C*4,E=h.matrixWorldInverse;o.getNormalMatrix(E),(f===null||f.length<u)&&(f=new Float32Array(u));for(let _=0,D=d;_!==C;++_,D+=4)r.copy(g[_]).applyMatrix4(E,o),r.normal.toArray(f,D),f[D+3]=r.constant}c.value=f,c.needsUpdate=!0}return t.numPlanes=C,t.numIntersection=0,f}}var Ci=class extends Ge{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},i=[n,n,n,n,n,n];this.texture=new ZA(i),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},i=new Hn(5,5,5),s=new ln({name:"CubemapFromEquirect",uniforms:sA(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:be,blending:eA});s.uniforms.tEquirect.value=e;let r=new Fe(i,s),o=e.minFilter;return e.minFilter===yn&&(e.minFilter=Ie),new _A(1,10,this).update(t,r),e.minFilter=o,r.geometry.dispose(),r.material.dispose(),this}clear(t,e=!0,n=!0,i=!0){let s=t.getRenderTarget();for(let r=0;r<6;r++)t.setRenderTarget(this,r),t.clear(e,n,i);t.setRenderTarget(s)}},Dc=256,Uf=3,Rf=20,Wc=256,Kc=16,Lf=3,Nf=new R,Hf=new It,Mr=class A{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new _A(1,10,null),this._boxMesh=new Fe(new Hn(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,i=100,s={}){let{size:r=256,position:o=Nf}=s,c=this._renderer;this._setSize(r);let a=this._allocateTarget(),l=this._getSourceTarget(!0);e>0&&(l.texture.mipmapsAutoUpdate=!1);let g=c.autoClear,h=c.autoClearColor,d=c.autoClearDepth,m=c.autoClearStencil,C=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,C===null&&(t.background=c.getClearColor(Hf));let f=new _A(n,i,l);return f.position.copy(o),f.update(c,t),c.autoClear=g,c.autoClearColor=h,c.autoClearDepth=d,c.autoClearStencil=m,t.background=C,e>0&&(l.texture.mipmapsAutoUpdate=!0,this._blur(a,e)),this._applyPMREM(a),a}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=yc(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=_c(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Dc,wc(t))}_fromTexture(t,e){t.mapping===AA||t.mapping===QA?this._setSize(t.image.length===0?Dc:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=xc(t,!1,!1),n=Math.log2(t)-Uf;for(let i=0;i<=n;i++)e.texture.mipmaps.push({width:t>>i,height:t>>i});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=xc(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let i=this._boxMesh,s=this._cubeCamera;i.material=n,s.renderTarget=t,s.activeMipmapLevel=e;let r=t.width>>e;t.viewport.set(0,0,r,r),s.update(this._renderer,i),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===AA||t.mapping===QA?(this._cubemapMaterial===null&&(this._cubemapMaterial=yc()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=_c()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Of(),this._integrationMaterial=Gf());let e=this._cubeSize,n=t.texture.mipmaps.length-1,i=this._ggxMaterial.uniforms;i.envMap.value=this._sourceTarget.texture;let s=this._integrationMaterial.uniforms;s.envMap.value=this._sourceTarget.texture,s.sourceLod.value=Math.log2(e/Kc);for(let r=0;r<=n;r++){let o=A.lodToRoughness(r,n);if(r>n-Lf)s.roughness.value=o,this._renderCube(t,r,this._integrationMaterial);else{let c=o>0?Math.log2(e)+.5*Math.log2(6/(Wc*Math.pow(o,4)))+.5:0;i.roughness.value=o,i.lodBias.value=c,this._renderCube(t,r,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=kf());let n=this._blurMaterial,i=n.uniforms,s=this._sourceTarget;i.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,i.envMap.value=s.texture,this._renderCube(t,0,n),i.envMap.value=t.texture,this._renderCube(s,0,n)}};function xc(A,t,e){return new Ci(A,{minFilter:yn,generateMipmaps:t,type:An,colorSpace:kA,depthBuffer:e})}function Ei(A,t,e){return new ln({name:A,uniforms:t,vertexShader:Nt.cube_vert,fragmentShader:e,side:be,blending:eA,depthTest:!1,depthWrite:!1})}function Of(){return Ei("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Wc}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Gf(){return Ei("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Kc}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function kf(){return Ei("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Rf}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function _c(){return Ei("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function yc(){return Ei("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function zf(A){let t=new WeakMap,e=new WeakMap,n=null;function i(h,d=!1){return h==null?null:d?r(h):s(h)}function s(h){if(h&&h.isTexture){let d=h.mapping;if(d===Fs||d===Us)if(t.has(h)){let m=t.get(h).texture;return o(m,h.mapping)}else{let m=h.image;if(m&&m.height>0){let C=new Ci(m.height);return C.fromEquirectangularTexture(A,h),t.set(h,C),h.addEventListener("dispose",a),o(C.texture,h.mapping)}else return null}}return h}function r(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,m=d===Fs||d===Us,C=d===AA||d===QA;if(m||C){let f=e.get(h),u=f!==void 0?f.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==u)return n===null&&(n=new Mr(A)),f=m?n.fromEquirectangular(h,f):n.fromCubemap(h,f),f.texture.pmremVersion=h.pmremVersion,e.set(h,f),f.texture;if(f!==void 0)return f.texture;{let E=h.image;return m&&E&&E.height>0||C&&E&&c(E)?(n===null&&(n=new Mr(A)),f=m?n.fromEquirectangular(h):n.fromCubemap(h),f.texture.pmremVersion=h.pmremVersion,e.set(h,f),h.addEventListener("dispose",l),f.texture):null}}}return h}function o(h,d){return d===Fs?h.mapping=AA:d===Us&&(h.mapping=QA),h}function c(h){let d=0,m=6;for(let C=0;C<m;C++)h[C]!==void 0&&d++;return d===m}function a(h){let d=h.target;d.removeEventListener("dispose",a);let m=t.get(d);m!==void 0&&(t.delete(d),m.dispose())}function l(h){let d=h.target;d.removeEventListener("dispose",l);let m=e.get(d);m!==void 0&&(e.delete(d),m.dispose())}function g(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:i,dispose:g}}function Vf(A){let t={};function e(n){if(t[n]!==void 0)return t[n];let i=A.getExtension(n);return t[n]=i,i}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let i=e(n);return i===null&&OA("WebGLRenderer: "+n+" extension not supported."),i}}}function Yf(A,t,e,n){let i={},s=new WeakMap,r=new FinalizationRegistry(m=>delete i[m]);function o(m){c(m.target)}function c(m){m.index!==null&&t.remove(m.index);for(let f in m.attributes)t.remove(m.attributes[f]);m.removeEventListener("dispose",o),delete i[m.id],r.unregister(m);let C=s.get(m);C&&(t.remove(C),s.delete(m)),n.releaseStatesOfGeometry(m),m.isInstancedBufferGeometry===!0&&delete m._maxInstanceCount,e.memory.geometries--}function a(m,C){return i[C.id]!==void 0||(C.addEventListener("dispose",o),i[C.id]=new WeakRef(C),r.register(C,C.id,C),e.memory.geometries++),C}function l(m){let C=m.attributes;for(let f in C)t.update(C[f],A.ARRAY_BUFFER)}function g(m){let C=m.index,f=m.attributes.position,u=0;if(f===void 0)return;let E=C!==null?C.array.length:f.array.length/3-1,_=f.count>=65535?XA:KA,D=new _(Math.ceil(E/3)*6,1),S=D.array;if(C!==null){let p=C.array;u=C.version;for(let v=0,N=0;v<E;v+=3){let b=p[v+0],P=p[v+1],O=p[v+2];S[N++]=b,S[N++]=P,S[N++]=P,S[N++]=O,S[N++]=O,S[N++]=b}}else{u=f.version;for(let p=0,v=0;p<E;p+=3){let N=p+0,b=p+1,P=p+2;S[v++]=N,S[v++]=b,S[v++]=b,S[v++]=P,S[v++]=P,S[v++]=N}}D.version=u;let x=s.get(m);x&&t.remove(x),s.set(m,D)}function h(m){let C=s.get(m);if(C){let f=m.index;f!==null&&C.version<f.version&&g(m)}else g(m);return s.get(m)}function d(){for(let m in i){let C=i[m].deref();C!==void 0&&c(C)}}return{get:a,update:l,getWireframeAttribute:h,dispose:d}}function Jf(A,t,e){let n;function i(g){n=g}let s,r;function o(g){s=g.type,r=g.bytesPerElement}function c(g,h){A.drawElements(n,h,s,g*r),e.update(h,n,1)}function a(g,h,d){d!==0&&(A.drawElementsInstanced(n,h,s,g*r,d),e.update(h,n,d))}function l(g,h,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,h,0,s,g,0,d);let C=0;for(let f=0;f<d;f++)C+=h[f];e.update(C,n,1)}this.setMode=i,this.setIndex=o,this.render=c,this.renderInstances=a,this.renderMultiDraw=l}function Wf(A){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(s,r,o){switch(e.calls++,r){case A.TRIANGLES:e.triangles+=o*(s/3);break;case A.LINES:e.lines+=o*(s/2);break;case A.LINE_STRIP:e.lines+=o*(s-1);break;case A.LINE_LOOP:e.lines+=o*s;break;case A.POINTS:e.points+=o*s;break;default:Qt("WebGLInfo: Unknown draw mode:",r);break}}function i(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:i,update:n}}function Kf(A,t,e){let n=new WeakMap,i=new Ae;function s(r,o,c){let a=r.morphTargetInfluences,l=o.morphAttributes.position||o.morphAttributes.normal||o.morphAttributes.color,g=l!==void 0?l.length:0,h=n.get(o);if(h===void 0||h.count!==g){let N=function(){p.dispose(),n.delete(o),o.removeEventListener("dispose",N)};h!==void 0&&h.texture.dispose();let d=o.morphAttributes.position!==void 0,m=o.morphAttributes.normal!==void 0,C=o.morphAttributes.color!==void 0,f=o.morphAttributes.position||[],u=o.morphAttributes.normal||[],E=o.morphAttributes.color||[],_=0;d===!0&&(_=1),m===!0&&(_=2),C===!0&&(_=3);let D=o.attributes.position.count*_,S=1;D>t.maxTextureSize&&(S=Math.ceil(D/t.maxTextureSize),D=t.maxTextureSize);let x=new Float32Array(D*S*4*g),p=new YA(x,D,S,g);p.type=nn,p.needsUpdate=!0;let v=_*4;for(let b=0;b<g;b++){let P=f[b],O=u[b],J=E[b],I=D*S*4*b;for(let V=0;V<P.count;V++){let q=V*v;d===!0&&(i.fromBufferAttribute(P,V),x[I+q+0]=i.x,x[I+q+1]=i.y,x[I+q+2]=i.z,x[I+q+3]=0),m===!0&&(i.fromBufferAttribute(O,V),x[I+q+4]=i.x,x[I+q+5]=i.y,x[I+q+6]=i.z,x[I+q+7]=0),C===!0&&(i.fromBufferAttribute(J,V),x[I+q+8]=i.x,x[I+q+9]=i.y,x[I+q+10]=i.z,x[I+q+11]=J.itemSize===4?i.w:1)}}h={count:g,texture:p,size:new Vt(D,S)},n.set(o,h),o.addEventListener("dispose",N)}if(r.isInstancedMesh===!0&&r.morphTexture!==null)c.getUniforms().setValue(A,"morphTexture",r.morphTexture,e);else{let d=0;for(let C=0;C<a.length;C++)d+=a[C];let m=o.morphTargetsRelative?1:1-d;c.getUniforms().setValue(A,"morphTargetBaseInfluence",m),c.getUniforms().setValue(A,"morphTargetInfluences",a)}c.getUniforms().setValue(A,"morphTargetsTexture",h.texture,e),c.getUniforms().setValue(A,"morphTargetsTextureSize",h.size)}return{update:s}}function Xf(A,t,e,n,i){let s=new WeakMap;function r(a){let l=i.render.frame,g=a.geometry,h=t.get(a,g);if(s.get(h)!==l&&(t.update(h),s.set(h,l)),a.isInstancedMesh&&(a.hasEventListener("dispose",c)===!1&&a.addEventListener("dispose",c),s.get(a)!==l&&(e.update(a.instanceMatrix,A.ARRAY_BUFFER),a.instanceColor!==null&&e.update(a.instanceColor,A.ARRAY_BUFFER),s.set(a,l))),a.isSkinnedMesh){let d=a.skeleton;s.get(d)!==l&&(d.update(),s.set(d,l))}return h}function o(){s=new WeakMap}function c(a){let l=a.target;l.removeEventListener("dispose",c),n.releaseStatesOfObject(l),e.remove(l.instanceMatrix),l.instanceColor!==null&&e.remove(l.instanceColor)}return{update:r,dispose:o}}var qf={[fo]:"LINEAR_TONE_MAPPING",[go]:"REINHARD_TONE_MAPPING",[po]:"CINEON_TONE_MAPPING",[mo]:"ACES_FILMIC_TONE_MAPPING",[wo]:"AGX_TONE_MAPPING",[Co]:"NEUTRAL_TONE_MAPPING",[Bo]:"CUSTOM_TONE_MAPPING"};function Zf(A,t,e,n,i,s){let r=new Ge(t,e,{type:A,depthBuffer:i,stencilBuffer:s,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),o=null,c=null,a=null,l=new ke;l.setAttribute("position",new Ee([-1,3,0,-1,-1,0,3,-1,0],3)),l.setAttribute("uv",new Ee([0,2,0,0,2,0],2));let g=new Bs({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),h=new Fe(l,g),d=new ri(-1,1,1,-1,0,1),m=null,C=null,f=!1,u,E=null,_=[],D=!1;this.setSize=function(S,x){r.setSize(S,x),o!==null&&o.setSize(S,x),c!==null&&c.setSize(S,x);for(let p=0;p<_.length;p++){let v=_[p];v.setSize&&v.setSize(S,x)}},this.setEffects=function(S){_=S,D=_.length>0&&_[0].isRenderPass===!0;let x=r.width,p=r.height;_.length>0&&o===null&&(o=new Ge(x,p,{type:An,depthBuffer:!1,stencilBuffer:!1}),c=new Ge(x,p,{type:An,depthBuffer:!1,stencilBuffer:!1}));let v=i===!0&&_.some(N=>N.needsDepthTexture===!0);v!==(r.depthTexture!==null)&&(v===!0&&a===null&&(a=new _n(x,p),s===!0&&(a.format=Sn,a.type=iA)),r.dispose(),r.depthTexture=v?a:null,r.resolveDepthBuffer=v,r.storeMultisampledDepthBuffer=v);for(let N=0;N<_.length;N++){let b=_[N];b.setSize&&b.setSize(x,p),v&&b.needsDepthTexture===!0&&b.setDepthTexture&&b.setDepthTexture(a)}},this.begin=function(S,x){if(f||S.toneMapping===un&&_.length===0)return!1;if(E=x,x!==null){let p=x.width,v=x.height;(r.width!==p||r.height!==v)&&this.setSize(p,v)}return D===!1&&S.setRenderTarget(r),u=S.toneMapping,S.toneMapping=un,!0},this.hasRenderPass=function(){return D},this.end=function(S,x){S.toneMapping=u,f=!0;let p=r,v=o;for(let N=0;N<_.length;N++){let b=_[N];b.enabled!==!1&&(b.render(S,v,p,x),b.needsSwap!==!1&&(p=v,v=v===o?c:o))}if(m!==S.outputColorSpace||C!==S.toneMapping){m=S.outputColorSpace,C=S.toneMapping,g.defines={},kt.getTransfer(m)===Wt&&(g.defines.SRGB_TRANSFER="");let N=qf[C];N&&(g.defines[N]=""),g.needsUpdate=!0}g.uniforms.tDiffuse.value=p.texture,S.setRenderTarget(E),S.render(h,d),E=null,f=!1},this.isCompositing=function(){return f},this.dispose=function(){r.dispose(),o!==null&&o.dispose(),c!==null&&c.dispose(),l.dispose(),g.dispose()}}var Xc=new Pe,qc=new _n(1,1),Zc=new jA(1),jc=new YA,$c=new hs,tl=new ZA,Sc=[],Qc=[],Ic=new Float32Array(16),bc=new Float32Array(9),Tc=new Float32Array(4);function TA(A,t,e){let n=A[0];if(n<=0||n>0)return A;let i=t*e,s=Sc[i];if(s===void 0&&(s=new Float32Array(i),Sc[i]=s),t!==0){n.toArray(s,0);for(let r=1,o=0;r!==t;++r)o+=e,A[r].toArray(s,o)}return s}function he(A,t){if(A.length!==t.length)return!1;for(let e=0,n=A.length;e<n;e++)if(A[e]!==t[e])return!1;return!0}function ue(A,t){for(let e=0,n=t.length;e<n;e++)A[e]=t[e]}function Dr(A,t){let e=Qc[t];e===void 0&&(e=new Int32Array(t),Qc[t]=e);for(let n=0;n!==t;++n)e[n]=A.allocateTextureUnit();return e}function jf(A,t){let e=this.cache;e[0]!==t&&(A.uniform1f(this.addr,t),e[0]=t)}function $f(A,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(A.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(he(e,t))return;A.uniform2fv(this.addr,t),ue(e,t)}}function td(A,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(A.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(A.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(he(e,t))return;A.uniform3fv(this.addr,t),ue(e,t)}}function ed(A,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(A.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(he(e,t))return;A.uniform4fv(this.addr,t),ue(e,t)}}function nd(A,t){let e=this.cache,n=t.elements;if(n===void 0){if(he(e,t))return;A.uniformMatrix2fv(this.addr,!1,t),ue(e,t)}else{if(he(e,n))return;Tc.set(n),A.uniformMatrix2fv(this.addr,!1,Tc),ue(e,n)}}function Ad(A,t){let e=this.cache,n=t.elements;if(n===void 0){if(he(e,t))return;A.uniformMatrix3fv(this.addr,!1,t),ue(e,t)}else{if(he(e,n))return;bc.set(n),A.uniformMatrix3fv(this.addr,!1,bc),ue(e,n)}}function id(A,t){let e=this.cache,n=t.elements;if(n===void 0){if(he(e,t))return;A.uniformMatrix4fv(this.addr,!1,t),ue(e,t)}else{if(he(e,n))return;Ic.set(n),A.uniformMatrix4fv(this.addr,!1,Ic),ue(e,n)}}function sd(A,t){let e=this.cache;e[0]!==t&&(A.uniform1i(this.addr,t),e[0]=t)}function rd(A,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(A.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(he(e,t))return;A.uniform2iv(this.addr,t),ue(e,t)}}function od(A,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(A.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(he(e,t))return;A.uniform3iv(this.addr,t),ue(e,t)}}function ad(A,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(A.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(he(e,t))return;A.uniform4iv(this.addr,t),ue(e,t)}}function cd(A,t){let e=this.cache;e[0]!==t&&(A.uniform1ui(this.addr,t),e[0]=t)}function ld(A,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(A.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(he(e,t))return;A.uniform2uiv(this.addr,t),ue(e,t)}}function hd(A,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(A.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(he(e,t))return;A.uniform3uiv(this.addr,t),ue(e,t)}}function ud(A,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(A.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(he(e,t))return;A.uniform4uiv(this.addr,t),ue(e,t)}}function xr(A){return A.version===0&&(A.compareFunction=bo,A.needsUpdate=!0),A}function fd(A,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(A.uniform1i(this.addr,i),n[0]=i);let s;this.type===A.SAMPLER_2D_SHADOW?s=xr(qc):s=Xc,e.setTexture2D(t||s,i)}function dd(A,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(A.uniform1i(this.addr,i),n[0]=i),e.setTexture3D(t||$c,i)}function gd(A,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(A.uniform1i(this.addr,i),n[0]=i);let s;this.type===A.SAMPLER_CUBE_SHADOW?s=xr(Zc):s=tl,e.setTextureCube(t||s,i)}function pd(A,t,e){let n=this.cache,i=e.allocateTextureUnit();n[0]!==i&&(A.uniform1i(this.addr,i),n[0]=i),e.setTexture2DArray(t||jc,i)}function md(A){switch(A){case 5126:return jf;case 35664:return $f;case 35665:return td;case 35666:return ed;case 35674:return nd;case 35675:return Ad;case 35676:return id;case 5124:case 35670:return sd;case 35667:case 35671:return rd;case 35668:case 35672:return od;case 35669:case 35673:return ad;case 5125:return cd;case 36294:return ld;case 36295:return hd;case 36296:return ud;case 35678:case 36198:case 36298:case 36306:case 35682:return fd;case 35679:case 36299:case 36307:return dd;case 35680:case 36300:case 36308:case 36293:return gd;case 36289:case 36303:case 36311:case 36292:return pd}}function Bd(A,t){A.uniform1fv(this.addr,t)}function wd(A,t){let e=TA(t,this.size,2);A.uniform2fv(this.addr,e)}function Cd(A,t){let e=TA(t,this.size,3);A.uniform3fv(this.addr,e)}function Ed(A,t){let e=TA(t,this.size,4);A.uniform4fv(this.addr,e)}function Md(A,t){let e=TA(t,this.size,4);A.uniformMatrix2fv(this.addr,!1,e)}function vd(A,t){let e=TA(t,this.size,9);A.uniformMatrix3fv(this.addr,!1,e)}function Dd(A,t){let e=TA(t,this.size,16);A.uniformMatrix4fv(this.addr,!1,e)}function xd(A,t){A.uniform1iv(this.addr,t)}function _d(A,t){A.uniform2iv(this.addr,t)}function yd(A,t){A.uniform3iv(this.addr,t)}function Sd(A,t){A.uniform4iv(this.addr,t)}function Qd(A,t){A.uniform1uiv(this.addr,t)}function Id(A,t){A.uniform2uiv(this.addr,t)}function bd(A,t){A.uniform3uiv(this.addr,t)}function Td(A,t){A.uniform4uiv(this.addr,t)}function Pd(A,t,e){let n=this.cache,i=t.length,s=Dr(e,i);he(n,s)||(A.uniform1iv(this.addr,s),ue(n,s));let r;this.type===A.SAMPLER_2D_SHADOW?r=xr(qc):r=Xc;for(let o=0;o!==i;++o)e.setTexture2D(t[o]||r,s[o])}function Fd(A,t,e){let n=this.cache,i=t.length,s=Dr(e,i);he(n,s)||(A.uniform1iv(this.addr,s),ue(n,s));for(let r=0;r!==i;++r)e.setTexture3D(t[r]||$c,s[r])}function Ud(A,t,e){let n=this.cache,i=t.length,s=Dr(e,i);he(n,s)||(A.uniform1iv(this.addr,s),ue(n,s));let r;this.type===A.SAMPLER_CUBE_SHADOW?r=xr(Zc):r=tl;for(let o=0;o!==i;++o)e.setTextureCube(t[o]||r,s[o])}function Rd(A,t,e){let n=this.cache,i=t.length,s=Dr(e,i);he(n,s)||(A.uniform1iv(this.addr,s),ue(n,s));for(let r=0;r!==i;++r)e.setTexture2DArray(t[r]||jc,s[r])}function Ld(A){switch(A){case 5126:return Bd;case 35664:return wd;case 35665:return Cd;case 35666:return Ed;case 35674:return Md;case 35675:return vd;case 35676:return Dd;case 5124:case 35670:return xd;case 35667:case 35671:return _d;case 35668:case 35672:return yd;case 35669:case 35673:return Sd;case 5125:return Qd;case 36294:return Id;case 36295:return bd;case 36296:return Td;case 35678:case 36198:case 36298:case 36306:case 35682:return Pd;case 35679:case 36299:case 36307:return Fd;case 35680:case 36300:case 36308:case 36293:return Ud;case 36289:case 36303:case 36311:case 36292:return Rd}}var Go=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=md(e.type)}},ko=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Ld(e.type)}},zo=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let i=this.seq;for(let s=0,r=i.length;s!==r;++s){let o=i[s];o.setValue(t,e[o.id],n)}}},Ho=/(\w+)(\])?(\[|\.)?/g;function Pc(A,t){A.seq.push(t),A.map[t.id]=t}function Nd(A,t,e){let n=A.name,i=n.length;for(Ho.lastIndex=0;;){let s=Ho.exec(n),r=Ho.lastIndex,o=s[1],c=s[2]==="]",a=s[3];if(c&&(o=o|0),a===void 0||a==="["&&r+2===i){Pc(e,a===void 0?new Go(o,A,t):new ko(o,A,t));break}else{let g=e.map[o];g===void 0&&(g=new zo(o),Pc(e,g)),e=g}}}var bA=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let r=0;r<n;++r){let o=t.getActiveUniform(e,r),c=t.getUniformLocation(e,o.name);Nd(o,c,this)}let i=[],s=[];for(let r of this.seq)r.type===t.SAMPLER_2D_SHADOW||r.type===t.SAMPLER_CUBE_SHADOW||r.type===t.SAMPLER_2D_ARRAY_SHADOW?i.push(r):s.push(r);i.length>0&&(this.seq=i.concat(s))}setValue(t,e,n,i){let s=this.map[e];s!==void 0&&s.setValue(t,n,i)}setOptional(t,e,n){let i=e[n];i!==void 0&&this.setValue(t,n,i)}static upload(t,e,n,i){for(let s=0,r=e.length;s!==r;++s){let o=e[s],c=n[o.id];c.needsUpdate!==!1&&o.setValue(t,c.value,i)}}static seqWithValue(t,e){let n=[];for(let i=0,s=t.length;i!==s;++i){let r=t[i];r.id in e&&n.push(r)}return n}};function Fc(A,t,e){let n=A.createShader(t);return A.shaderSource(n,e),A.compileShader(n),n}var Hd=37297,Od=0;function Gd(A,t){let e=A.split(`
`),n=[],i=Math.max(t-6,0),s=Math.min(t+6,e.length);for(let r=i;r<s;r++){let o=r+1;n.push(`${o===t?">":" "} ${o}: ${e[r]}`)}return n.join(`
`)}var Uc=new bt;function kd(A){kt._getMatrix(Uc,kt.workingColorSpace,A);let t=`mat3( ${Uc.elements.map(e=>e.toFixed(4))} )`;switch(kt.getTransfer(A)){case zA:return[t,"LinearTransferOETF"];case Wt:return[t,"sRGBTransferOETF"];default:return yt("WebGLProgram: Unsupported color space: ",A),[t,"LinearTransferOETF"]}}function Rc(A,t,e){let n=A.getShaderParameter(t,A.COMPILE_STATUS),s=(A.getShaderInfoLog(t)||"").trim();if(n&&s==="")return"";let r=/ERROR: 0:(\d+)/.exec(s);if(r){let o=parseInt(r[1]);return e.toUpperCase()+`

`+s+`

`+Gd(A.getShaderSource(t),o)}else return s}function zd(A,t){let e=kd(t);return[`vec4 ${A}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var Vd={[fo]:"Linear",[go]:"Reinhard",[po]:"Cineon",[mo]:"ACESFilmic",[wo]:"AgX",[Co]:"Neutral",[Bo]:"Custom"};function Yd(A,t){let e=Vd[t];return e===void 0?(yt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+A+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+A+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Er=new R;function Jd(){kt.getLuminanceCoefficients(Er);let A=Er.x.toFixed(4),t=Er.y.toFixed(4),e=Er.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${A}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Wd(A){return[A.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",A.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(wi).join(`
`)}function Kd(A){let t=[];for(let e in A){let n=A[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function Xd(A,t){let e={},n=A.getProgramParameter(t,A.ACTIVE_ATTRIBUTES);for(let i=0;i<n;i++){let s=A.getActiveAttrib(t,i),r=s.name,o=1;s.type===A.FLOAT_MAT2&&(o=2),s.type===A.FLOAT_MAT3&&(o=3),s.type===A.FLOAT_MAT4&&(o=4),e[r]={type:s.type,location:A.getAttribLocation(t,r),locationSize:o}}return e}function wi(A){return A!==""}function Lc(A,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return A.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Nc(A,t){return A.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var qd=/^[ \t]*#include +<([\w\d./]+)>/gm;function Vo(A){return A.replace(qd,Zd)}function Zd(A,t){let e=Nt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Vo(e)}var jd=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Hc(A){return A.replace(jd,$d)}function $d(A,t,e,n){let i="";for(let s=parseInt(t);s<parseInt(e);s++)i+=n.replace(/\[\s*i\s*\]/g,"[ "+s+" ]").replace(/UNROLLED_LOOP_INDEX/g,s);return i}function Oc(A){let t=`precision ${A.precision} float;
	precision ${A.precision} int;
	precision ${A.precision} sampler2D;
	precision ${A.precision} samplerCube;
	precision ${A.precision} sampler3D;
	precision ${A.precision} sampler2DArray;
	precision ${A.precision} sampler2DShadow;
	precision ${A.precision} samplerCubeShadow;
	precision ${A.precision} sampler2DArrayShadow;
	precision ${A.precision} isampler2D;
	precision ${A.precision} isampler3D;
	precision ${A.precision} isamplerCube;
	precision ${A.precision} isampler2DArray;
	precision ${A.precision} usampler2D;
	precision ${A.precision} usampler3D;
	precision ${A.precision} usamplerCube;
	precision ${A.precision} usampler2DArray;
	`;return A.precision==="highp"?t+=`
#define HIGH_PRECISION`:A.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:A.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var tg={[ci]:"SHADOWMAP_TYPE_PCF",[yA]:"SHADOWMAP_TYPE_VSM"};function eg(A){return tg[A.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var ng={[QA]:"ENVMAP_MODE_REFRACTION"};function Ag(A){return A.envMap===!1?"ENVMAP_MODE_REFLECTION":ng[A.envMapMode]||"ENVMAP_MODE_REFLECTION"}var ig={[Ps]:"ENVMAP_BLENDING_MULTIPLY",[Ac]:"ENVMAP_BLENDING_MIX",[ic]:"ENVMAP_BLENDING_ADD"};function sg(A){return A.envMap===!1?"ENVMAP_BLENDING_NONE":ig[A.combine]||"ENVMAP_BLENDING_NONE"}function rg(A,t,e,n){let i=A.getContext(),s=e.defines,r=e.vertexShader,o=e.fragmentShader,c=eg(e),a=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",l=Ag(e),g=sg(e),h=Wd(e),d=Kd(s),m=i.createProgram(),C,f,u=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(C=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(wi).join(`
`),C.length>0&&(C+=`
`),f=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(wi).join(`
`),f.length>0&&(f+=`
`)):(C=[Oc(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(wi).join(`
`),f=[Oc(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+a:"",e.envMap?"#define "+l:"",e.envMap?"#define "+g:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==un?"#define TONE_MAPPING":"",e.toneMapping!==un?Nt.tonemapping_pars_fragment:"",e.toneMapping!==un?Yd("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Nt.colorspace_pars_fragment,zd("linearToOutputTexel",e.outputColorSpace),Jd(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(wi).join(`
`)),r=Vo(r),r=Lc(r,e),r=Nc(r,e),o=Vo(o),o=Lc(o,e),o=Nc(o,e),r=Hc(r),o=Hc(o),e.isRawShaderMaterial!==!0&&(u=`#version 300 es
`,C=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+C,f=["#define varying in",e.glslVersion===To?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===To?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+f);let E=u+C+r,_=u+f+o,D=Fc(i,i.VERTEX_SHADER,E),S=Fc(i,i.FRAGMENT_SHADER,_);i.attachShader(m,D),i.attachShader(m,S),e.index0AttributeName!==void 0?i.bindAttribLocation(m,0,e.index0AttributeName):e.hasPositionAttribute===!0&&i.bindAttribLocation(m,0,"position"),i.linkProgram(m);function x(b){if(A.debug.checkShaderErrors){let P=i.getProgramInfoLog(m)||"",O=i.getShaderInfoLog(D)||"",J=i.getShaderInfoLog(S)||"",I=P.trim(),V=O.trim(),q=J.trim(),G=!0,et=!0;if(i.getProgramParameter(m,i.LINK_STATUS)===!1)if(G=!1,typeof A.debug.onShaderError=="function")A.debug.onShaderError(i,m,D,S);else{let z=Rc(i,D,"vertex"),j=Rc(i,S,"fragment");Qt("WebGLProgram: Shader Error "+i.getError()+" - VALIDATE_STATUS "+i.getProgramParameter(m,i.VALIDATE_STATUS)+`

Material Name: `+b.name+`
Material Type: `+b.type+`

Program Info Log: `+I+`
`+z+`
`+j)}else I!==""?yt("WebGLProgram: Program Info Log:",I):(V===""||q==="")&&(et=!1);et&&(b.diagnostics={runnable:G,programLog:I,vertexShader:{log:V,prefix:C},fragmentShader:{log:q,prefix:f}})}i.deleteShader(D),i.deleteShader(S),p=new bA(i,m),v=Xd(i,m)}let p;this.getUniforms=function(){return p===void 0&&x(this),p};let v;this.getAttributes=function(){return v===void 0&&x(this),v};let N=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return N===!1&&(N=i.getProgramParameter(m,Hd)),N},this.destroy=function(){n.releaseStatesOfProgram(this),i.deleteProgram(m),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Od++,this.cacheKey=t,this.usedTimes=1,this.program=m,this.vertexShader=D,this.fragmentShader=S,this}var og=0,Yo=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let i=this._getShaderCacheForMaterial(t);return i.has(e)===!1&&(i.add(e),e.usedTimes++),i.has(n)===!1&&(i.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Jo(t),e.set(t,n)),n}},Jo=class{constructor(t){this.id=og++,this.code=t,this.usedTimes=0}};function ag(A){return A===Vn||A===gi||A===pi}function cg(A,t,e,n,i,s){let r=new JA,o=new Yo,c=new Set,a=[],l=new Map,g=n.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(p){return c.add(p),p===0?"uv":`uv${p}`}function m(p,v,N,b,P,O){let J=b.fog,I=P.geometry,V=p.isMeshStandardMaterial||p.isMeshLambertMaterial||p.isMeshPhongMaterial?b.environment:null,q=p.isMeshStandardMaterial||p.isMeshLambertMaterial&&!p.envMap||p.isMeshPhongMaterial&&!p.envMap,G=t.get(p.envMap||V,q),et=h[p.type],z=n.precision;p.precision!==null&&(z=n.getMaxPrecision(p.precision),z!==p.precision&&yt("WebGLProgram.getParameters:",p.precision,"not supported, using",z,"instead."));let j=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,$=j!==void 0?j.length:0,Et=0;I.morphAttributes.position!==void 0&&(Et=1),I.morphAttributes.normal!==void 0&&(Et=2),I.morphAttributes.color!==void 0&&(Et=3);let Pt,K,dt,Bt;if(et){let ut=dn[et];Pt=ut.vertexShader,K=ut.fragmentShader}else{Pt=p.vertexShader,K=p.fragmentShader;let ut=o.getVertexShaderStage(p),Xt=o.getFragmentShaderStage(p);o.update(p,ut,Xt),dt=ut.id,Bt=Xt.id}let xt=A.getRenderTarget(),gt=A.state.buffers.depth.getReversed(),Ut=P.isInstancedMesh===!0,re=P.isBatchedMesh===!0,St=!!p.map,Kt=!!p.matcap,qt=!!G,Ht=qt&&G.isPMREMTexture===!0,Be=!!p.aoMap,ce=!!p.lightMap,Te=!!p.bumpMap&&p.wireframe===!1,ie=!!p.normalMap,rn=!!p.displacementMap,fe=!!p.emissiveMap,Ve=!!p.metalnessMap,Ye=!!p.roughnessMap,Je=p.anisotropy>0,T=p.clearcoat>0,We=p.diffuseRoughness>0,ee=p.dispersion>0,ne=p.retroreflectivity>0,ht=p.iridescence>0,le=p.sheen>0,_t=p.transmission>0,Tt=Je&&!!p.anisotropyMap,M=T&&!!p.clearcoatMap,B=T&&!!p.clearcoatNormalMap,U=T&&!!p.clearcoatRoughnessMap,tt=We&&!!p.diffuseRoughnessMap,Z=ht&&!!p.iridescenceMap,it=ht&&!!p.iridescenceThicknessMap,ct=le&&!!p.sheenColorMap,Y=le&&!!p.sheenRoughnessMap,W=!!p.specularMap,rt=!!p.specularColorMap,y=!!p.specularIntensityMap,X=_t&&!!p.transmissionMap,k=_t&&!!p.thicknessMap,ot=!!p.gradientMap,At=!!p.alphaMap,st=p.alphaTest>0,vt=!!p.alphaHash,Lt=!!p.extensions,nt=un;p.toneMapped&&(xt===null||xt.isXRRenderTarget===!0)&&(nt=A.toneMapping);let Dt=Ht?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,Rt={shaderID:et,shaderType:p.type,shaderName:p.name,vertexShader:Pt,fragmentShader:K,defines:p.defines,customVertexShaderID:dt,customFragmentShaderID:Bt,isRawShaderMaterial:p.isRawShaderMaterial===!0,glslVersion:p.glslVersion,precision:z,batching:re,batchingColor:re&&P._colorsTexture!==null,instancing:Ut,instancingColor:Ut&&P.instanceColor!==null,instancingMorph:Ut&&P.morphTexture!==null,outputColorSpace:xt===null?A.outputColorSpace:xt.isXRRenderTarget===!0?xt.texture.colorSpace:kt.workingColorSpace,alphaToCoverage:!!p.alphaToCoverage,map:St,matcap:Kt,envMap:qt,envMapMode:qt&&G.mapping,envMapPMREM:Ht,envMapMaxLod:Ht?Dt.length-1:null,envMapSize:Ht?Dt[0].width:null,aoMap:Be,lightMap:ce,bumpMap:Te,normalMap:ie,displacementMap:rn,emissiveMap:fe,normalMapObjectSpace:ie&&p.normalMapType===oc,normalMapTangentSpace:ie&&p.normalMapType===wr,packedNormalMap:ie&&p.normalMapType===wr&&ag(p.normalMap.format),metalnessMap:Ve,roughnessMap:Ye,anisotropy:Je,anisotropyMap:Tt,clearcoat:T,clearcoatMap:M,clearcoatNormalMap:B,clearcoatRoughnessMap:U,diffuseRoughness:We,diffuseRoughnessMap:tt,dispersion:ee,retroreflection:ne,iridescence:ht,iridescenceMap:Z,iridescenceThicknessMap:it,sheen:le,sheenColorMap:ct,sheenRoughnessMap:Y,specularMap:W,specularColorMap:rt,specularIntensityMap:y,transmission:_t,transmissionMap:X,thicknessMap:k,gradientMap:ot,opaque:p.transparent===!1&&p.blending===SA&&p.alphaToCoverage===!1,alphaMap:At,alphaTest:st,alphaHash:vt,combine:p.combine,mapUv:St&&d(p.map.channel),aoMapUv:Be&&d(p.aoMap.channel),lightMapUv:ce&&d(p.lightMap.channel),bumpMapUv:Te&&d(p.bumpMap.channel),normalMapUv:ie&&d(p.normalMap.channel),displacementMapUv:rn&&d(p.displacementMap.channel),emissiveMapUv:fe&&d(p.emissiveMap.channel),metalnessMapUv:Ve&&d(p.metalnessMap.channel),roughnessMapUv:Ye&&d(p.roughnessMap.channel),anisotropyMapUv:Tt&&d(p.anisotropyMap.channel),clearcoatMapUv:M&&d(p.clearcoatMap.channel),clearcoatNormalMapUv:B&&d(p.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:U&&d(p.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:tt&&d(p.diffuseRoughnessMap.channel),iridescenceMapUv:Z&&d(p.iridescenceMap.channel),iridescenceThicknessMapUv:it&&d(p.iridescenceThicknessMap.channel),sheenColorMapUv:ct&&d(p.sheenColorMap.channel),sheenRoughnessMapUv:Y&&d(p.sheenRoughnessMap.channel),specularMapUv:W&&d(p.specularMap.channel),specularColorMapUv:rt&&d(p.specularColorMap.channel),specularIntensityMapUv:y&&d(p.specularIntensityMap.channel),transmissionMapUv:X&&d(p.transmissionMap.channel),thicknessMapUv:k&&d(p.thicknessMap.channel),alphaMapUv:At&&d(p.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(ie||Je),vertexNormals:!!I.attributes.normal,vertexColors:p.vertexColors,vertexAlphas:p.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:P.isPoints===!0&&!!I.attributes.uv&&(St||At),fog:!!J,useFog:p.fog===!0,fogExp2:!!J&&J.isFogExp2,flatShading:p.wireframe===!1&&(p.flatShading===!0||I.attributes.normal===void 0&&ie===!1&&(p.isMeshLambertMaterial||p.isMeshPhongMaterial||p.isMeshStandardMaterial||p.isMeshPhysicalMaterial)),sizeAttenuation:p.sizeAttenuation===!0,logarithmicDepthBuffer:g,reversedDepthBuffer:gt,skinning:P.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:$,morphTextureStride:Et,numSunLights:v.sun.length,numDirLights:v.directional.length,numPointLights:v.point.length,numSpotLights:v.spot.length,numSpotLightMaps:v.spotLightMap.length,numRectAreaLights:v.rectArea.length,numHemiLights:v.hemi.length,numSunLightShadows:v.sunShadowMap.length,numDirLightShadows:v.directionalShadowMap.length,numPointLightShadows:v.pointShadowMap.length,numSpotLightShadows:v.spotShadowMap.length,numSpotLightShadowsWithMaps:v.numSpotLightShadowsWithMaps,numLightProbes:v.numLightProbes,numLightProbeGrids:O.filter(ut=>ut.texture!==null).length,numClippingPlanes:s.numPlanes,numClipIntersection:s.numIntersection,dithering:p.dithering,shadowMapEnabled:A.shadowMap.enabled&&N.length>0,shadowMapType:A.shadowMap.type,toneMapping:nt,decodeVideoTexture:St&&p.map.isVideoTexture===!0&&kt.getTransfer(p.map.colorSpace)===Wt,decodeVideoTextureEmissive:fe&&p.emissiveMap.isVideoTexture===!0&&kt.getTransfer(p.emissiveMap.colorSpace)===Wt,premultipliedAlpha:p.premultipliedAlpha,doubleSided:p.side===hn,flipSided:p.side===be,useDepthPacking:p.depthPacking>=0,depthPacking:p.depthPacking||0,index0AttributeName:p.index0AttributeName,extensionClipCullDistance:Lt&&p.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Lt&&p.extensions.multiDraw===!0||re)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:p.customProgramCacheKey()};return Rt.vertexUv1s=c.has(1),Rt.vertexUv2s=c.has(2),Rt.vertexUv3s=c.has(3),c.clear(),Rt}function C(p){let v=[];if(p.shaderID?v.push(p.shaderID):(v.push(p.customVertexShaderID),v.push(p.customFragmentShaderID)),p.defines!==void 0)for(let N in p.defines)v.push(N),v.push(p.defines[N]);return p.isRawShaderMaterial===!1&&(f(v,p),u(v,p),v.push(A.outputColorSpace)),v.push(p.customProgramCacheKey),v.join()}function f(p,v){p.push(v.precision),p.push(v.outputColorSpace),p.push(v.envMapMode),p.push(v.envMapPMREM),p.push(v.envMapMaxLod),p.push(v.envMapSize),p.push(v.mapUv),p.push(v.alphaMapUv),p.push(v.lightMapUv),p.push(v.aoMapUv),p.push(v.bumpMapUv),p.push(v.normalMapUv),p.push(v.displacementMapUv),p.push(v.emissiveMapUv),p.push(v.metalnessMapUv),p.push(v.roughnessMapUv),p.push(v.anisotropyMapUv),p.push(v.clearcoatMapUv),p.push(v.clearcoatNormalMapUv),p.push(v.clearcoatRoughnessMapUv),p.push(v.diffuseRoughnessMapUv),p.push(v.iridescenceMapUv),p.push(v.iridescenceThicknessMapUv),p.push(v.sheenColorMapUv),p.push(v.sheenRoughnessMapUv),p.push(v.specularMapUv),p.push(v.specularColorMapUv),p.push(v.specularIntensityMapUv),p.push(v.transmissionMapUv),p.push(v.thicknessMapUv),p.push(v.combine),p.push(v.fogExp2),p.push(v.sizeAttenuation),p.push(v.morphTargetsCount),p.push(v.numSunLights),p.push(v.numDirLights),p.push(v.numPointLights),p.push(v.numSpotLights),p.push(v.numSpotLightMaps),p.push(v.numHemiLights),p.push(v.numRectAreaLights),p.push(v.numSunLightShadows),p.push(v.numDirLightShadows),p.push(v.numPointLightShadows),p.push(v.numSpotLightShadows),p.push(v.numSpotLightShadowsWithMaps),p.push(v.numLightProbes),p.push(v.numLightProbeGrids),p.push(v.shadowMapType),p.push(v.toneMapping),p.push(v.numClippingPlanes),p.push(v.numClipIntersection),p.push(v.depthPacking)}function u(p,v){r.disableAll(),v.instancing&&r.enable(0),v.instancingColor&&r.enable(1),v.instancingMorph&&r.enable(2),v.matcap&&r.enable(3),v.envMap&&r.enable(4),v.normalMapObjectSpace&&r.enable(5),v.normalMapTangentSpace&&r.enable(6),v.clearcoat&&r.enable(7),v.iridescence&&r.enable(8),v.alphaTest&&r.enable(9),v.vertexColors&&r.enable(10),v.vertexAlphas&&r.enable(11),v.vertexUv1s&&r.enable(12),v.vertexUv2s&&r.enable(13),v.vertexUv3s&&r.enable(14),v.vertexTangents&&r.enable(15),v.anisotropy&&r.enable(16),v.alphaHash&&r.enable(17),v.batching&&r.enable(18),v.dispersion&&r.enable(19),v.retroreflection&&r.enable(24),v.diffuseRoughness&&r.enable(25),v.batchingColor&&r.enable(20),v.gradientMap&&r.enable(21),v.packedNormalMap&&r.enable(22),v.vertexNormals&&r.enable(23),p.push(r.mask),r.disableAll(),v.fog&&r.enable(0),v.useFog&&r.enable(1),v.flatShading&&r.enable(2),v.logarithmicDepthBuffer&&r.enable(3),v.reversedDepthBuffer&&r.enable(4),v.skinning&&r.enable(5),v.morphTargets&&r.enable(6),v.morphNormals&&r.enable(7),v.morphColors&&r.enable(8),v.premultipliedAlpha&&r.enable(9),v.shadowMapEnabled&&r.enable(10),v.doubleSided&&r.enable(11),v.flipSided&&r.enable(12),v.useDepthPacking&&r.enable(13),v.dithering&&r.enable(14),v.transmission&&r.enable(15),v.sheen&&r.enable(16),v.opaque&&r.enable(17),v.pointsUvs&&r.enable(18),v.decodeVideoTexture&&r.enable(19),v.decodeVideoTextureEmissive&&r.enable(20),v.alphaToCoverage&&r.enable(21),v.numLightProbeGrids>0&&r.enable(22),v.hasPositionAttribute&&r.enable(23),p.push(r.mask)}function E(p){let v=h[p.type],N;if(v){let b=dn[v];N=Ec.clone(b.uniforms)}else N=p.uniforms;return N}function _(p,v){let N=l.get(v);return N!==void 0?++N.usedTimes:(N=new rg(A,v,p,i),a.push(N),l.set(v,N)),N}function D(p){if(--p.usedTimes===0){let v=a.indexOf(p);a[v]=a[a.length-1],a.pop(),l.delete(p.cacheKey),p.destroy()}}function S(p){o.remove(p)}function x(){o.dispose()}return{getParameters:m,getProgramCacheKey:C,getUniforms:E,acquireProgram:_,releaseProgram:D,releaseShaderCache:S,programs:a,dispose:x}}function lg(){let A=new WeakMap;function t(r){return A.has(r)}function e(r){let o=A.get(r);return o===void 0&&(o={},A.set(r,o)),o}function n(r){A.delete(r)}function i(r,o,c){A.get(r)[o]=c}function s(){A=new WeakMap}return{has:t,get:e,remove:n,update:i,dispose:s}}function hg(A,t){return A.groupOrder!==t.groupOrder?A.groupOrder-t.groupOrder:A.renderOrder!==t.renderOrder?A.renderOrder-t.renderOrder:A.material.id!==t.material.id?A.material.id-t.material.id:A.materialVariant!==t.materialVariant?A.materialVariant-t.materialVariant:A.z!==t.z?A.z-t.z:A.id-t.id}function Gc(A,t){return A.groupOrder!==t.groupOrder?A.groupOrder-t.groupOrder:A.renderOrder!==t.renderOrder?A.renderOrder-t.renderOrder:A.z!==t.z?t.z-A.z:A.id-t.id}function kc(){let A=[],t=0,e=[],n=[],i=[];function s(){t=0,e.length=0,n.length=0,i.length=0}function r(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function o(h,d,m,C,f,u){let E=A[t];return E===void 0?(E={id:h.id,object:h,geometry:d,material:m,materialVariant:r(h),groupOrder:C,renderOrder:h.renderOrder,z:f,group:u},A[t]=E):(E.id=h.id,E.object=h,E.geometry=d,E.material=m,E.materialVariant=r(h),E.groupOrder=C,E.renderOrder=h.renderOrder,E.z=f,E.group=u),t++,E}function c(h,d,m,C,f,u,E){E.reversedDepth===!0&&(f=-f);let _=o(h,d,m,C,f,u);m.transmission>0?n.push(_):m.transparent===!0?i.push(_):e.push(_)}function a(h,d,m,C,f,u){let E=o(h,d,m,C,f,u);m.transmission>0?n.unshift(E):m.transparent===!0?i.unshift(E):e.unshift(E)}function l(h,d){e.length>1&&e.sort(h||hg),n.length>1&&n.sort(d||Gc),i.length>1&&i.sort(d||Gc)}function g(){for(let h=t,d=A.length;h<d;h++){let m=A[h];if(m.id===null)break;m.id=null,m.object=null,m.geometry=null,m.material=null,m.group=null}}return{opaque:e,transmissive:n,transparent:i,init:s,push:c,unshift:a,finish:g,sort:l}}function ug(){let A=new WeakMap;function t(n,i){let s=A.get(n),r;return s===void 0?(r=new kc,A.set(n,[r])):i>=s.length?(r=new kc,s.push(r)):r=s[i],r}function e(){A=new WeakMap}return{get:t,dispose:e}}function fg(){let A={};return{get:function(t){if(A[t.id]!==void 0)return A[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new R,color:new It};break;case"SpotLight":e={position:new R,direction:new R,color:new It,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new R,color:new It,distance:0,decay:0};break;case"HemisphereLight":e={direction:new R,skyColor:new It,groundColor:new It};break;case"RectAreaLight":e={color:new It,position:new R,halfWidth:new R,halfHeight:new R};break}return A[t.id]=e,e}}}function dg(){let A={};return{get:function(t){if(A[t.id]!==void 0)return A[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Vt,shadowCameraNear:1,shadowCameraFar:1e3};break}return A[t.id]=e,e}}}var gg=0;function pg(A,t){return(t.castShadow?2:0)-(A.castShadow?2:0)+(t.map?1:0)-(A.map?1:0)}function mg(A){let t=new fg,e=dg(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let a=0;a<9;a++)n.probe.push(new R);let i=new R,s=new te,r=new te;function o(a){let l=0,g=0,h=0;for(let O=0;O<9;O++)n.probe[O].set(0,0,0);let d=0,m=0,C=0,f=0,u=0,E=0,_=0,D=0,S=0,x=0,p=0,v=0,N=0,b=0;a.sort(pg);for(let O=0,J=a.length;O<J;O++){let I=a[O],V=I.color,q=I.intensity,G=I.distance,et=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Vn?et=I.shadow.map.texture:et=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)l+=V.r*q,g+=V.g*q,h+=V.b*q;else if(I.isLightProbe){for(let z=0;z<9;z++)n.probe[z].addScaledVector(I.sh.coefficients[z],q);b++}else if(I.isSunLight){let z=t.get(I);if(z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,$=e.get(I);$.shadowIntensity=j.intensity,$.shadowBias=j.bias,$.shadowNormalBias=j.normalBias,$.shadowRadius=j.radius,$.shadowMapSize.copy(j.mapSize).multiply(j.getFrameExtents()),n.sunShadow[m]=$,n.sunShadowMap[m]=et;let Et=j.getViewportCount();for(let Pt=0;Pt<Et;Pt++)n.sunShadowMatrix[C+Pt]=j.getMatrix(Pt),n.sunShadowCascade[C+Pt]=j._cascadeData[Pt];C+=Et,m++}n.sun[d]=z,d++}else if(I.isDirectionalLight){let z=t.get(I);if(z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let j=I.shadow,$=e.get(I);$.shadowIntensity=j.intensity,$.shadowBias=j.bias,$.shadowNormalBias=j.normalBias,$.shadowRadius=j.radius,$.shadowMapSize=j.mapSize,n.directionalShadow[f]=$,n.directionalShadowMap[f]=et,n.directionalShadowMatrix[f]=I.shadow.matrix,S++}n.directional[f]=z,f++}else if(I.isSpotLight){let z=t.get(I);z.position.setFromMatrixPosition(I.matrixWorld),z.color.copy(V).multiplyScalar(q),z.distance=G,z.coneCos=Math.cos(I.angle),z.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),z.decay=I.decay,n.spot[E]=z;let j=I.shadow;if(I.map&&(n.spotLightMap[v]=I.map,v++,j.updateMatrices(I),I.castShadow&&N++),n.spotLightMatrix[E]=j.matrix,I.castShadow){let $=e.get(I);$.shadowIntensity=j.intensity,$.shadowBias=j.bias,$.shadowNormalBias=j.normalBias,$.shadowRadius=j.radius,$.shadowMapSize=j.mapSize,n.spotShadow[E]=$,n.spotShadowMap[E]=et,p++}E++}else if(I.isRectAreaLight){let z=t.get(I);z.color.copy(V).multiplyScalar(q),z.halfWidth.set(I.width*.5,0,0),z.halfHeight.set(0,I.height*.5,0),n.rectArea[_]=z,_++}else if(I.isPointLight){let z=t.get(I);if(z.color.copy(I.color).multiplyScalar(I.intensity),z.distance=I.distance,z.decay=I.decay,I.castShadow){let j=I.shadow,$=e.get(I);$.shadowIntensity=j.intensity,$.shadowBias=j.bias,$.shadowNormalBias=j.normalBias,$.shadowRadius=j.radius,$.shadowMapSize=j.mapSize,$.shadowCameraNear=j.camera.near,$.shadowCameraFar=j.camera.far,n.pointShadow[u]=$,n.pointShadowMap[u]=et,n.pointShadowMatrix[u]=I.shadow.matrix,x++}n.point[u]=z,u++}else if(I.isHemisphereLight){let z=t.get(I);z.skyColor.copy(I.color).multiplyScalar(q),z.groundColor.copy(I.groundColor).multiplyScalar(q),n.hemi[D]=z,D++}}_>0&&(A.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=l,n.ambient[1]=g,n.ambient[2]=h;let P=n.hash;(P.sunLength!==d||P.directionalLength!==f||P.pointLength!==u||P.spotLength!==E||P.rectAreaLength!==_||P.hemiLength!==D||P.numSunShadows!==m||P.numDirectionalShadows!==S||P.numPointShadows!==x||P.numSpotShadows!==p||P.numSpotMaps!==v||P.numLightProbes!==b)&&(n.sun.length=d,n.directional.length=f,n.spot.length=E,n.rectArea.length=_,n.point.length=u,n.hemi.length=D,n.sunShadow.length=m,n.sunShadowMap.length=m,n.sunShadowMatrix.length=C,n.sunShadowCascade.length=C,n.directionalShadow.length=S,n.directionalShadowMap.length=S,n.directionalShadowMatrix.length=S,n.pointShadow.length=x,n.pointShadowMap.length=x,n.pointShadowMatrix.length=x,n.spotShadow.length=p,n.spotShadowMap.length=p,n.spotLightMatrix.length=p+v-N,n.spotLightMap.length=v,n.numSpotLightShadowsWithMaps=N,n.numLightProbes=b,P.sunLength=d,P.directionalLength=f,P.pointLength=u,P.spotLength=E,P.rectAreaLength=_,P.hemiLength=D,P.numSunShadows=m,P.numDirectionalShadows=S,P.numPointShadows=x,P.numSpotShadows=p,P.numSpotMaps=v,P.numLightProbes=b,n.version=gg++)}function c(a,l){let g=0,h=0,d=0,m=0,C=0,f=0,u=l.matrixWorldInverse;for(let E=0,_=a.length;E<_;E++){let D=a[E];if(D.isSunLight){let S=n.sun[g];S.direction.setFromMatrixPosition(D.matrixWorld),S.direction.transformDirection(u),g++}else if(D.isDirectionalLight){let S=n.directional[h];S.direction.setFromMatrixPosition(D.matrixWorld),i.setFromMatrixPosition(D.target.matrixWorld),S.direction.sub(i),S.direction.transformDirection(u),h++}else if(D.isSpotLight){let S=n.spot[m];S.position.setFromMatrixPosition(D.matrixWorld),S.position.applyMatrix4(u),S.direction.setFromMatrixPosition(D.matrixWorld),i.setFromMatrixPosition(D.target.matrixWorld),S.direction.sub(i),S.direction.transformDirection(u),m++}else if(D.isRectAreaLight){let S=n.rectArea[C];S.position.setFromMatrixPosition(D.matrixWorld),S.position.applyMatrix4(u),r.identity(),s.copy(D.matrixWorld),s.premultiply(u),r.extractRotation(s),S.halfWidth.set(D.width*.5,0,0),S.halfHeight.set(0,D.height*.5,0),S.halfWidth.applyMatrix4(r),S.halfHeight.applyMatrix4(r),C++}else if(D.isPointLight){let S=n.point[d];S.position.setFromMatrixPosition(D.matrixWorld),S.position.applyMatrix4(u),d++}else if(D.isHemisphereLight){let S=n.hemi[f];S.direction.setFromMatrixPosition(D.matrixWorld),S.direction.transformDirection(u),f++}}}return{setup:o,setupView:c,state:n}}function zc(A){let t=new mg(A),e=[],n=[],i=[];function s(g){l.camera=g,e.length=0,n.length=0,i.length=0}function r(g){g.isLightProbeGrid?i.push(g):e.push(g)}function o(g){n.push(g)}function c(){t.setup(e),i.sort((g,h)=>g.priority-h.priority||g.id-h.id)}function a(g){t.setupView(e,g)}let l={lightsArray:e,shadowsArray:n,lightProbeGridArray:i,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:s,state:l,setupLights:c,setupLightsView:a,pushLight:r,pushShadow:o}}function Bg(A){let t=new WeakMap;function e(i,s=0){let r=t.get(i),o;return r===void 0?(o=new zc(A),t.set(i,[o])):s>=r.length?(o=new zc(A),r.push(o)):o=r[s],o}function n(){t=new WeakMap}return{get:e,dispose:n}}var wg=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,Cg=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,Eg=[new R(1,0,0),new R(-1,0,0),new R(0,1,0),new R(0,-1,0),new R(0,0,1),new R(0,0,-1)],Mg=[new R(0,-1,0),new R(0,-1,0),new R(0,0,1),new R(0,0,-1),new R(0,-1,0),new R(0,-1,0)],Vc=new te,Bi=new R,Oo=new R;function vg(A,t,e){let n=new Nn,i=new Vt,s=new Vt,r=new Ae,o=new ws,c=new Cs,a={},l=e.maxTextureSize,g={[zn]:be,[be]:zn,[hn]:hn},h=new ln({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Vt},radius:{value:4}},vertexShader:wg,fragmentShader:Cg}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let m=new ke;m.setAttribute("position",new He(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let C=new Fe(m,h),f=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ci;let u=this.type;this.render=function(x,p,v){if(f.enabled===!1||f.autoUpdate===!1&&f.needsUpdate===!1||x.length===0)return;this.type===Na&&(yt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ci);let N=A.getRenderTarget(),b=A.getActiveCubeFace(),P=A.getActiveMipmapLevel(),O=A.state;O.setBlending(eA),O.buffers.depth.getReversed()===!0?O.buffers.color.setClear(0,0,0,0):O.buffers.color.setClear(1,1,1,1),O.buffers.depth.setTest(!0),O.setScissorTest(!1);let J=u!==this.type;J&&p.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(V=>V.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,V=x.length;I<V;I++){let q=x[I],G=q.shadow;if(G===void 0){yt("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;i.copy(G.mapSize);let et=G.getFrameExtents();i.multiply(et),s.copy(G.mapSize),(i.x>l||i.y>l)&&(i.x>l&&(s.x=Math.floor(l/et.x),i.x=s.x*et.x,G.mapSize.x=s.x),i.y>l&&(s.y=Math.floor(l/et.y),i.y=s.y*et.y,G.mapSize.y=s.y));let z=A.state.buffers.depth.getReversed();if(G.camera._reversedDepth=z,G.map===null||J===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===yA){if(q.isPointLight){yt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Ge(i.x,i.y,{format:Vn,type:An,minFilter:Ie,magFilter:Ie,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new _n(i.x,i.y,nn),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=vn,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=me,G.map.depthTexture.magFilter=me}else q.isPointLight?(G.map=new Ci(i.x),G.map.depthTexture=new jA(i.x,en)):(G.map=new Ge(i.x,i.y),G.map.depthTexture=new _n(i.x,i.y,en)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=vn,this.type===ci?(G.map.depthTexture.compareFunction=z?Io:Qo,G.map.depthTexture.minFilter=Ie,G.map.depthTexture.magFilter=Ie):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=me,G.map.depthTexture.magFilter=me);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==i.x||G.map.height!==i.y)&&G.map.setSize(i.x,i.y);let j=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,v);let $=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:v.layers;for(let Et=0;Et<j;Et++){let Pt=G.getCamera(Et);if(q.isPointLight){let K=G.camera,dt=G.matrix,Bt=q.distance||K.far;Bt!==K.far&&(K.far=Bt,K.updateProjectionMatrix()),Bi.setFromMatrixPosition(q.matrixWorld),K.position.copy(Bi),Oo.copy(K.position),Oo.add(Eg[Et]),K.up.copy(Mg[Et]),K.lookAt(Oo),K.updateMatrixWorld(),dt.makeTranslation(-Bi.x,-Bi.y,-Bi.z),Vc.multiplyMatrices(K.projectionMatrix,K.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Vc,K.coordinateSystem,K.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)A.setRenderTarget(G.map,Et),A.clear();else{Et===0&&(A.setRenderTarget(G.map),A.clear());let K=G.getViewport(Et);r.set(s.x*K.x,s.y*K.y,s.x*K.z,s.y*K.w),O.viewport(r)}n=G.getFrustum(Et),D(p,v,Pt,q,$,this.type)}G.isPointLightShadow!==!0&&this.type===yA&&E(G,v),G.needsUpdate=!1}u=this.type,f.needsUpdate=!1,A.setRenderTarget(N,b,P)};function E(x,p){let v=t.update(C);h.defines.VSM_SAMPLES!==x.blurSamples&&(h.defines.VSM_SAMPLES=x.blurSamples,d.defines.VSM_SAMPLES=x.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),x.mapPass===null?x.mapPass=new Ge(i.x,i.y,{format:Vn,type:An}):(x.mapPass.width!==x.map.width||x.mapPass.height!==x.map.height)&&x.mapPass.setSize(x.map.width,x.map.height),h.uniforms.shadow_pass.value=x.map.depthTexture,h.uniforms.resolution.value.set(x.map.width,x.map.height),h.uniforms.radius.value=x.radius,A.setRenderTarget(x.mapPass),A.clear(),A.renderBufferDirect(p,null,v,h,C,null),d.uniforms.shadow_pass.value=x.mapPass.texture,d.uniforms.resolution.value.set(x.map.width,x.map.height),d.uniforms.radius.value=x.radius,A.setRenderTarget(x.map),A.clear(),A.renderBufferDirect(p,null,v,d,C,null)}function _(x,p,v,N){let b=null,P=v.isPointLight===!0?x.customDistanceMaterial:x.customDepthMaterial;if(P!==void 0)b=P;else if(b=v.isPointLight===!0?c:o,A.localClippingEnabled&&p.clipShadows===!0&&Array.isArray(p.clippingPlanes)&&p.clippingPlanes.length!==0||p.displacementMap&&p.displacementScale!==0||p.alphaMap&&p.alphaTest>0||p.map&&p.alphaTest>0||p.alphaToCoverage===!0){let O=b.uuid,J=p.uuid,I=a[O];I===void 0&&(I={},a[O]=I);let V=I[J];V===void 0&&(V=b.clone(),I[J]=V,p.addEventListener("dispose",S)),b=V}if(b.visible=p.visible,b.wireframe=p.wireframe,N===yA?b.side=p.shadowSide!==null?p.shadowSide:p.side:b.side=p.shadowSide!==null?p.shadowSide:g[p.side],b.alphaMap=p.alphaMap,b.alphaTest=p.alphaToCoverage===!0?.5:p.alphaTest,b.map=p.map,b.clipShadows=p.clipShadows,b.clippingPlanes=p.clippingPlanes,b.clipIntersection=p.clipIntersection,b.displacementMap=p.displacementMap,b.displacementScale=p.displacementScale,b.displacementBias=p.displacementBias,b.wireframeLinewidth=p.wireframeLinewidth,b.linewidth=p.linewidth,v.isPointLight===!0&&b.isMeshDistanceMaterial===!0){let O=A.properties.get(b);O.light=v}return b}function D(x,p,v,N,b,P){if(x.visible===!1)return;if(x.layers.test(b)&&(x.isMesh||x.isLine||x.isPoints)&&(x.castShadow||x.receiveShadow&&P===yA)&&(!x.frustumCulled||x.intersectsFrustum(n))){x.modelViewMatrix.multiplyMatrices(v.matrixWorldInverse,x.matrixWorld);let I=t.update(x),V=x.material;if(Array.isArray(V)){let q=I.groups;for(let G=0,et=q.length;G<et;G++){let z=q[G],j=V[z.materialIndex];if(j&&j.visible){let $=_(x,j,N,P);x.onBeforeShadow(A,x,p,v,I,$,z),A.renderBufferDirect(v,null,I,$,x,z),x.onAfterShadow(A,x,p,v,I,$,z)}}}else if(V.visible){let q=_(x,V,N,P);x.onBeforeShadow(A,x,p,v,I,q,null),A.renderBufferDirect(v,null,I,q,x,null),x.onAfterShadow(A,x,p,v,I,q,null)}}let J=x.children;for(let I=0,V=J.length;I<V;I++)D(J[I],p,v,N,b,P)}function S(x){x.target.removeEventListener("dispose",S);for(let v in a){let N=a[v],b=x.target.uuid;b in N&&(N[b].dispose(),delete N[b])}}}function Dg(A,t){function e(){let y=!1,X=new Ae,k=null,ot=new Ae(0,0,0,0);return{setMask:function(At){k!==At&&!y&&(A.colorMask(At,At,At,At),k=At)},setLocked:function(At){y=At},setClear:function(At,st,vt,Lt,nt){nt===!0&&(At*=Lt,st*=Lt,vt*=Lt),X.set(At,st,vt,Lt),ot.equals(X)===!1&&(A.clearColor(At,st,vt,Lt),ot.copy(X))},reset:function(){y=!1,k=null,ot.set(-1,0,0,0)}}}function n(){let y=!1,X=!1,k=null,ot=null,At=null;return{setReversed:function(st){if(X!==st){let vt=t.get("EXT_clip_control");st?vt.clipControlEXT(vt.LOWER_LEFT_EXT,vt.ZERO_TO_ONE_EXT):vt.clipControlEXT(vt.LOWER_LEFT_EXT,vt.NEGATIVE_ONE_TO_ONE_EXT),X=st;let Lt=At;At=null,this.setClear(Lt)}},getReversed:function(){return X},setTest:function(st){st?gt(A.DEPTH_TEST):Ut(A.DEPTH_TEST)},setMask:function(st){k!==st&&!y&&(A.depthMask(st),k=st)},setFunc:function(st){if(X&&(st=Bc[st]),ot!==st){switch(st){case ji:A.depthFunc(A.NEVER);break;case $i:A.depthFunc(A.ALWAYS);break;case ts:A.depthFunc(A.LESS);break;case CA:A.depthFunc(A.LEQUAL);break;case es:A.depthFunc(A.EQUAL);break;case ns:A.depthFunc(A.GEQUAL);break;case As:A.depthFunc(A.GREATER);break;case is:A.depthFunc(A.NOTEQUAL);break;default:A.depthFunc(A.LEQUAL)}ot=st}},setLocked:function(st){y=st},setClear:function(st){At!==st&&(At=st,X&&(st=1-st),A.clearDepth(st))},reset:function(){y=!1,k=null,ot=null,At=null,X=!1}}}function i(){let y=!1,X=null,k=null,ot=null,At=null,st=null,vt=null,Lt=null,nt=null;return{setTest:function(Dt){y||(Dt?gt(A.STENCIL_TEST):Ut(A.STENCIL_TEST))},setMask:function(Dt){X!==Dt&&!y&&(A.stencilMask(Dt),X=Dt)},setFunc:function(Dt,Rt,ut){(k!==Dt||ot!==Rt||At!==ut)&&(A.stencilFunc(Dt,Rt,ut),k=Dt,ot=Rt,At=ut)},setOp:function(Dt,Rt,ut){(st!==Dt||vt!==Rt||Lt!==ut)&&(A.stencilOp(Dt,Rt,ut),st=Dt,vt=Rt,Lt=ut)},setLocked:function(Dt){y=Dt},setClear:function(Dt){nt!==Dt&&(A.clearStencil(Dt),nt=Dt)},reset:function(){y=!1,X=null,k=null,ot=null,At=null,st=null,vt=null,Lt=null,nt=null}}}let s=new e,r=new n,o=new i,c={},a=new WeakMap,l={},g={},h={},d=new WeakMap,m=[],C=null,f=!1,u=null,E=null,_=null,D=null,S=null,x=null,p=null,v=new It(0,0,0),N=0,b=!1,P=null,O=null,J=null,I=null,V=null,q=A.getParameter(A.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,et=0,z=A.getParameter(A.VERSION);z.indexOf("WebGL")!==-1?(et=parseFloat(/^WebGL (\d)/.exec(z)[1]),G=et>=1):z.indexOf("OpenGL ES")!==-1&&(et=parseFloat(/^OpenGL ES (\d)/.exec(z)[1]),G=et>=2);let j=null,$={},Et=A.getParameter(A.SCISSOR_BOX),Pt=A.getParameter(A.VIEWPORT),K=new Ae().fromArray(Et),dt=new Ae().fromArray(Pt);function Bt(y,X,k,ot){let At=new Uint8Array(4),st=A.createTexture();A.bindTexture(y,st),A.texParameteri(y,A.TEXTURE_MIN_FILTER,A.NEAREST),A.texParameteri(y,A.TEXTURE_MAG_FILTER,A.NEAREST);for(let vt=0;vt<k;vt++)y===A.TEXTURE_3D||y===A.TEXTURE_2D_ARRAY?A.texImage3D(X,0,A.RGBA,1,1,ot,0,A.RGBA,A.UNSIGNED_BYTE,At):A.texImage2D(X+vt,0,A.RGBA,1,1,0,A.RGBA,A.UNSIGNED_BYTE,At);return st}let xt={};xt[A.TEXTURE_2D]=Bt(A.TEXTURE_2D,A.TEXTURE_2D,1),xt[A.TEXTURE_CUBE_MAP]=Bt(A.TEXTURE_CUBE_MAP,A.TEXTURE_CUBE_MAP_POSITIVE_X,6),xt[A.TEXTURE_2D_ARRAY]=Bt(A.TEXTURE_2D_ARRAY,A.TEXTURE_2D_ARRAY,1,1),xt[A.TEXTURE_3D]=Bt(A.TEXTURE_3D,A.TEXTURE_3D,1,1),s.setClear(0,0,0,1),r.setClear(1),o.setClear(0),gt(A.DEPTH_TEST),r.setFunc(CA),Te(!1),ie(oo),gt(A.CULL_FACE),Be(eA);function gt(y){l[y]!==!0&&(A.enable(y),l[y]=!0)}function Ut(y){l[y]!==!1&&(A.disable(y),l[y]=!1)}function re(y,X){return h[y]!==X?(A.bindFramebuffer(y,X),h[y]=X,y===A.DRAW_FRAMEBUFFER&&(h[A.FRAMEBUFFER]=X),y===A.FRAMEBUFFER&&(h[A.DRAW_FRAMEBUFFER]=X),!0):!1}function St(y,X){let k=m,ot=!1;if(y){k=d.get(X),k===void 0&&(k=[],d.set(X,k));let At=y.textures;if(k.length!==At.length||k[0]!==A.COLOR_ATTACHMENT0){for(let st=0,vt=At.length;st<vt;st++)k[st]=A.COLOR_ATTACHMENT0+st;k.length=At.length,ot=!0}}else k[0]!==A.BACK&&(k[0]=A.BACK,ot=!0);ot&&A.drawBuffers(k)}function Kt(y){return C!==y?(A.useProgram(y),C=y,!0):!1}let qt={[nA]:A.FUNC_ADD,[Oa]:A.FUNC_SUBTRACT,[Ga]:A.FUNC_REVERSE_SUBTRACT};qt[ka]=A.MIN,qt[za]=A.MAX;let Ht={[Va]:A.ZERO,[Ya]:A.ONE,[Ja]:A.SRC_COLOR,[ho]:A.SRC_ALPHA,[ja]:A.SRC_ALPHA_SATURATE,[qa]:A.DST_COLOR,[Ka]:A.DST_ALPHA,[Wa]:A.ONE_MINUS_SRC_COLOR,[uo]:A.ONE_MINUS_SRC_ALPHA,[Za]:A.ONE_MINUS_DST_COLOR,[Xa]:A.ONE_MINUS_DST_ALPHA,[$a]:A.CONSTANT_COLOR,[tc]:A.ONE_MINUS_CONSTANT_COLOR,[ec]:A.CONSTANT_ALPHA,[nc]:A.ONE_MINUS_CONSTANT_ALPHA};function Be(y,X,k,ot,At,st,vt,Lt,nt,Dt){if(y===eA){f===!0&&(Ut(A.BLEND),f=!1);return}if(f===!1&&(gt(A.BLEND),f=!0),y!==Ha){if(y!==u||Dt!==b){if((E!==nA||S!==nA)&&(A.blendEquation(A.FUNC_ADD),E=nA,S=nA),Dt)switch(y){case SA:A.blendFuncSeparate(A.ONE,A.ONE_MINUS_SRC_ALPHA,A.ONE,A.ONE_MINUS_SRC_ALPHA);break;case ao:A.blendFunc(A.ONE,A.ONE);break;case co:A.blendFuncSeparate(A.ZERO,A.ONE_MINUS_SRC_COLOR,A.ZERO,A.ONE);break;case lo:A.blendFuncSeparate(A.DST_COLOR,A.ONE_MINUS_SRC_ALPHA,A.ZERO,A.ONE);break;default:Qt("WebGLState: Invalid blending: ",y);break}else switch(y){case SA:A.blendFuncSeparate(A.SRC_ALPHA,A.ONE_MINUS_SRC_ALPHA,A.ONE,A.ONE_MINUS_SRC_ALPHA);break;case ao:A.blendFuncSeparate(A.SRC_ALPHA,A.ONE,A.ONE,A.ONE);break;case co:Qt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case lo:Qt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Qt("WebGLState: Invalid blending: ",y);break}_=null,D=null,x=null,p=null,v.set(0,0,0),N=0,u=y,b=Dt}return}At=At||X,st=st||k,vt=vt||ot,(X!==E||At!==S)&&(A.blendEquationSeparate(qt[X],qt[At]),E=X,S=At),(k!==_||ot!==D||st!==x||vt!==p)&&(A.blendFuncSeparate(Ht[k],Ht[ot],Ht[st],Ht[vt]),_=k,D=ot,x=st,p=vt),(Lt.equals(v)===!1||nt!==N)&&(A.blendColor(Lt.r,Lt.g,Lt.b,nt),v.copy(Lt),N=nt),u=y,b=!1}function ce(y,X){y.side===hn?Ut(A.CULL_FACE):gt(A.CULL_FACE);let k=y.side===be;X&&(k=!k),Te(k),y.blending===SA&&y.transparent===!1?Be(eA):Be(y.blending,y.blendEquation,y.blendSrc,y.blendDst,y.blendEquationAlpha,y.blendSrcAlpha,y.blendDstAlpha,y.blendColor,y.blendAlpha,y.premultipliedAlpha),r.setFunc(y.depthFunc),r.setTest(y.depthTest),r.setMask(y.depthWrite),s.setMask(y.colorWrite);let ot=y.stencilWrite;o.setTest(ot),ot&&(o.setMask(y.stencilWriteMask),o.setFunc(y.stencilFunc,y.stencilRef,y.stencilFuncMask),o.setOp(y.stencilFail,y.stencilZFail,y.stencilZPass)),fe(y.polygonOffset,y.polygonOffsetFactor,y.polygonOffsetUnits),y.alphaToCoverage===!0?gt(A.SAMPLE_ALPHA_TO_COVERAGE):Ut(A.SAMPLE_ALPHA_TO_COVERAGE)}function Te(y){P!==y&&(y?A.frontFace(A.CW):A.frontFace(A.CCW),P=y)}function ie(y){y!==Ra?(gt(A.CULL_FACE),y!==O&&(y===oo?A.cullFace(A.BACK):y===La?A.cullFace(A.FRONT):A.cullFace(A.FRONT_AND_BACK))):Ut(A.CULL_FACE),O=y}function rn(y){y!==J&&(G&&A.lineWidth(y),J=y)}function fe(y,X,k){y?(gt(A.POLYGON_OFFSET_FILL),(I!==X||V!==k)&&(I=X,V=k,r.getReversed()&&(X=-X,k=-k),A.polygonOffset(X,k))):Ut(A.POLYGON_OFFSET_FILL)}function Ve(y){y?gt(A.SCISSOR_TEST):Ut(A.SCISSOR_TEST)}function Ye(y){y===void 0&&(y=A.TEXTURE0+q-1),j!==y&&(A.activeTexture(y),j=y)}function Je(y,X,k){k===void 0&&(j===null?k=A.TEXTURE0+q-1:k=j);let ot=$[k];ot===void 0&&(ot={type:void 0,texture:void 0},$[k]=ot),(ot.type!==y||ot.texture!==X)&&(j!==k&&(A.activeTexture(k),j=k),A.bindTexture(y,X||xt[y]),ot.type=y,ot.texture=X)}function T(){let y=$[j];y!==void 0&&y.type!==void 0&&(A.bindTexture(y.type,null),y.type=void 0,y.texture=void 0)}function We(){try{A.compressedTexImage2D(...arguments)}catch(y){Qt("WebGLState:",y)}}function ee(){try{A.compressedTexImage3D(...arguments)}catch(y){Qt("WebGLState:",y)}}function ne(){try{A.texSubImage2D(...arguments)}catch(y){Qt("WebGLState:",y)}}function ht(){try{A.texSubImage3D(...arguments)}catch(y){Qt("WebGLState:",y)}}function le(){try{A.compressedTexSubImage2D(...arguments)}catch(y){Qt("WebGLState:",y)}}function _t(){try{A.compressedTexSubImage3D(...arguments)}catch(y){Qt("WebGLState:",y)}}function Tt(){try{A.texStorage2D(...arguments)}catch(y){Qt("WebGLState:",y)}}function M(){try{A.texStorage3D(...arguments)}catch(y){Qt("WebGLState:",y)}}function B(){try{A.texImage2D(...arguments)}catch(y){Qt("WebGLState:",y)}}function U(){try{A.texImage3D(...arguments)}catch(y){Qt("WebGLState:",y)}}function tt(y){return g[y]!==void 0?g[y]:A.getParameter(y)}function Z(y,X){g[y]!==X&&(A.pixelStorei(y,X),g[y]=X)}function it(y){K.equals(y)===!1&&(A.scissor(y.x,y.y,y.z,y.w),K.copy(y))}function ct(y){dt.equals(y)===!1&&(A.viewport(y.x,y.y,y.z,y.w),dt.copy(y))}function Y(y,X){let k=a.get(X);k===void 0&&(k=new WeakMap,a.set(X,k));let ot=k.get(y);ot===void 0&&(ot=A.getUniformBlockIndex(X,y.name),A.uniformBlockBinding(X,ot,ot),k.set(y,ot))}function W(y,X,k){let At=a.get(X).get(y);c[At]!==k&&(A.bindBufferBase(A.UNIFORM_BUFFER,At,k),c[At]=k)}function rt(){A.disable(A.BLEND),A.disable(A.CULL_FACE),A.disable(A.DEPTH_TEST),A.disable(A.POLYGON_OFFSET_FILL),A.disable(A.SCISSOR_TEST),A.disable(A.STENCIL_TEST),A.disable(A.SAMPLE_ALPHA_TO_COVERAGE),A.blendEquation(A.FUNC_ADD),A.blendFunc(A.ONE,A.ZERO),A.blendFuncSeparate(A.ONE,A.ZERO,A.ONE,A.ZERO),A.blendColor(0,0,0,0),A.colorMask(!0,!0,!0,!0),A.clearColor(0,0,0,0),A.depthMask(!0),A.depthFunc(A.LESS),r.setReversed(!1),A.clearDepth(1),A.stencilMask(4294967295),A.stencilFunc(A.ALWAYS,0,4294967295),A.stencilOp(A.KEEP,A.KEEP,A.KEEP),A.clearStencil(0),A.cullFace(A.BACK),A.frontFace(A.CCW),A.polygonOffset(0,0),A.activeTexture(A.TEXTURE0),A.bindFramebuffer(A.FRAMEBUFFER,null),A.bindFramebuffer(A.DRAW_FRAMEBUFFER,null),A.bindFramebuffer(A.READ_FRAMEBUFFER,null),A.useProgram(null),A.lineWidth(1),A.scissor(0,0,A.canvas.width,A.canvas.height),A.viewport(0,0,A.canvas.width,A.canvas.height),A.pixelStorei(A.PACK_ALIGNMENT,4),A.pixelStorei(A.UNPACK_ALIGNMENT,4),A.pixelStorei(A.UNPACK_FLIP_Y_WEBGL,!1),A.pixelStorei(A.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),A.pixelStorei(A.UNPACK_COLORSPACE_CONVERSION_WEBGL,A.BROWSER_DEFAULT_WEBGL),A.pixelStorei(A.PACK_ROW_LENGTH,0),A.pixelStorei(A.PACK_SKIP_PIXELS,0),A.pixelStorei(A.PACK_SKIP_ROWS,0),A.pixelStorei(A.UNPACK_ROW_LENGTH,0),A.pixelStorei(A.UNPACK_IMAGE_HEIGHT,0),A.pixelStorei(A.UNPACK_SKIP_PIXELS,0),A.pixelStorei(A.UNPACK_SKIP_ROWS,0),A.pixelStorei(A.UNPACK_SKIP_IMAGES,0),l={},g={},j=null,$={},h={},c={},d=new WeakMap,m=[],C=null,f=!1,u=null,E=null,_=null,D=null,S=null,x=null,p=null,v=new It(0,0,0),N=0,b=!1,P=null,O=null,J=null,I=null,V=null,K.set(0,0,A.canvas.width,A.canvas.height),dt.set(0,0,A.canvas.width,A.canvas.height),s.reset(),r.reset(),o.reset()}return{buffers:{color:s,depth:r,stencil:o},enable:gt,disable:Ut,bindFramebuffer:re,drawBuffers:St,useProgram:Kt,setBlending:Be,setMaterial:ce,setFlipSided:Te,setCullFace:ie,setLineWidth:rn,setPolygonOffset:fe,setScissorTest:Ve,activeTexture:Ye,bindTexture:Je,unbindTexture:T,compressedTexImage2D:We,compressedTexImage3D:ee,texImage2D:B,texImage3D:U,pixelStorei:Z,getParameter:tt,updateUBOMapping:Y,uniformBlockBinding:W,texStorage2D:Tt,texStorage3D:M,texSubImage2D:ne,texSubImage3D:ht,compressedTexSubImage2D:le,compressedTexSubImage3D:_t,scissor:it,viewport:ct,reset:rt}}function xg(A,t,e,n,i,s,r){let o=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),a=new Vt,l=new WeakMap,g=new Set,h,d=new WeakMap,m=new Set,C=new FinalizationRegistry(M=>m.delete(M)),f=!1;try{f=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function u(M,B){return f?new OffscreenCanvas(M,B):VA("canvas")}function E(M,B,U){let tt=1,Z=Tt(M);if((Z.width>U||Z.height>U)&&(tt=U/Math.max(Z.width,Z.height)),tt<1)if(typeof HTMLImageElement<"u"&&M instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&M instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&M instanceof ImageBitmap||typeof VideoFrame<"u"&&M instanceof VideoFrame){let it=Math.floor(tt*Z.width),ct=Math.floor(tt*Z.height);h===void 0&&(h=u(it,ct));let Y=B?u(it,ct):h;return Y.width=it,Y.height=ct,Y.getContext("2d").drawImage(M,0,0,it,ct),yt("WebGLRenderer: Texture has been resized from ("+Z.width+"x"+Z.height+") to ("+it+"x"+ct+")."),Y}else return"data"in M&&yt("WebGLRenderer: Image in DataTexture is too big ("+Z.width+"x"+Z.height+")."),M;return M}function _(M){return M.generateMipmaps}function D(M){A.generateMipmap(M)}function S(M){return M.isWebGLCubeRenderTarget?A.TEXTURE_CUBE_MAP:M.isWebGL3DRenderTarget?A.TEXTURE_3D:M.isWebGLArrayRenderTarget||M.isCompressedArrayTexture?A.TEXTURE_2D_ARRAY:A.TEXTURE_2D}function x(M,B,U,tt,Z,it=!1){if(M!==null){if(A[M]!==void 0)return A[M];yt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+M+"'")}let ct;tt&&(ct=t.get("EXT_texture_norm16"),ct||yt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=B;if(B===A.RED&&(U===A.FLOAT&&(Y=A.R32F),U===A.HALF_FLOAT&&(Y=A.R16F),U===A.UNSIGNED_BYTE&&(Y=A.R8),U===A.UNSIGNED_SHORT&&ct&&(Y=ct.R16_EXT),U===A.SHORT&&ct&&(Y=ct.R16_SNORM_EXT)),B===A.RED_INTEGER&&(U===A.UNSIGNED_BYTE&&(Y=A.R8UI),U===A.UNSIGNED_SHORT&&(Y=A.R16UI),U===A.UNSIGNED_INT&&(Y=A.R32UI),U===A.BYTE&&(Y=A.R8I),U===A.SHORT&&(Y=A.R16I),U===A.INT&&(Y=A.R32I)),B===A.RG&&(U===A.FLOAT&&(Y=A.RG32F),U===A.HALF_FLOAT&&(Y=A.RG16F),U===A.UNSIGNED_BYTE&&(Y=A.RG8),U===A.UNSIGNED_SHORT&&ct&&(Y=ct.RG16_EXT),U===A.SHORT&&ct&&(Y=ct.RG16_SNORM_EXT)),B===A.RG_INTEGER&&(U===A.UNSIGNED_BYTE&&(Y=A.RG8UI),U===A.UNSIGNED_SHORT&&(Y=A.RG16UI),U===A.UNSIGNED_INT&&(Y=A.RG32UI),U===A.BYTE&&(Y=A.RG8I),U===A.SHORT&&(Y=A.RG16I),U===A.INT&&(Y=A.RG32I)),B===A.RGB_INTEGER&&(U===A.UNSIGNED_BYTE&&(Y=A.RGB8UI),U===A.UNSIGNED_SHORT&&(Y=A.RGB16UI),U===A.UNSIGNED_INT&&(Y=A.RGB32UI),U===A.BYTE&&(Y=A.RGB8I),U===A.SHORT&&(Y=A.RGB16I),U===A.INT&&(Y=A.RGB32I)),B===A.RGBA_INTEGER&&(U===A.UNSIGNED_BYTE&&(Y=A.RGBA8UI),U===A.UNSIGNED_SHORT&&(Y=A.RGBA16UI),U===A.UNSIGNED_INT&&(Y=A.RGBA32UI),U===A.BYTE&&(Y=A.RGBA8I),U===A.SHORT&&(Y=A.RGBA16I),U===A.INT&&(Y=A.RGBA32I)),B===A.RGB&&(U===A.UNSIGNED_SHORT&&ct&&(Y=ct.RGB16_EXT),U===A.SHORT&&ct&&(Y=ct.RGB16_SNORM_EXT),U===A.UNSIGNED_INT_5_9_9_9_REV&&(Y=A.RGB9_E5),U===A.UNSIGNED_INT_10F_11F_11F_REV&&(Y=A.R11F_G11F_B10F)),B===A.RGBA){let W=it?zA:kt.getTransfer(Z);U===A.FLOAT&&(Y=A.RGBA32F),U===A.HALF_FLOAT&&(Y=A.RGBA16F),U===A.UNSIGNED_BYTE&&(Y=W===Wt?A.SRGB8_ALPHA8:A.RGBA8),U===A.UNSIGNED_SHORT&&ct&&(Y=ct.RGBA16_EXT),U===A.SHORT&&ct&&(Y=ct.RGBA16_SNORM_EXT),U===A.UNSIGNED_SHORT_4_4_4_4&&(Y=A.RGBA4),U===A.UNSIGNED_SHORT_5_5_5_1&&(Y=A.RGB5_A1)}return(Y===A.R16F||Y===A.R32F||Y===A.RG16F||Y===A.RG32F||Y===A.RGBA16F||Y===A.RGBA32F)&&t.get("EXT_color_buffer_float"),Y}function p(M,B){let U;return M?B===null||B===en||B===iA?U=A.DEPTH24_STENCIL8:B===nn?U=A.DEPTH32F_STENCIL8:B===IA&&(U=A.DEPTH24_STENCIL8,yt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):B===null||B===en||B===iA?U=A.DEPTH_COMPONENT24:B===nn?U=A.DEPTH_COMPONENT32F:B===IA&&(U=A.DEPTH_COMPONENT16),U}function v(M,B){return _(M)===!0||M.isFramebufferTexture&&M.minFilter!==me&&M.minFilter!==Ie?Math.log2(Math.max(B.width,B.height))+1:M.mipmaps.length>0?M.mipmaps.length:M.isCompressedTexture&&Array.isArray(M.image)?B.mipmaps.length:1}function N(M){let B=new WeakRef(M);n.get(M).__ref=B,m.add(B),C.register(M,B,B)}function b(M){let B=n.get(M).__ref;B!==void 0&&(m.delete(B),C.unregister(B))}function P(M){J(M.target)}function O(M){I(M.target)}function J(M){M.removeEventListener("dispose",P),b(M),q(M),M.isVideoTexture&&l.delete(M),M.isHTMLTexture&&g.delete(M)}function I(M){M.removeEventListener("dispose",O),b(M),et(M)}function V(){for(let M of m){let B=M.deref();B!==void 0&&(B.isRenderTarget===!0?I(B):J(B))}m.clear(),g.clear()}function q(M){let B=n.get(M);if(B.__webglInit===void 0)return;let U=M.source,tt=d.get(U);if(tt){let Z=tt[B.__cacheKey];Z.usedTimes--,Z.usedTimes===0&&G(M),Object.keys(tt).length===0&&d.delete(U)}n.remove(M)}function G(M){let B=n.get(M);A.deleteTexture(B.__webglTexture);let U=M.source,tt=d.get(U);delete tt[B.__cacheKey],r.memory.textures--}function et(M){let B=n.get(M);B.__depthDisposeCallback&&B.__depthDisposeCallback();let U=M.depthTexture;if(U&&U.renderTarget===M&&J(U),M.isWebGLCubeRenderTarget)for(let Z=0;Z<6;Z++){if(Array.isArray(B.__webglFramebuffer[Z]))for(let it=0;it<B.__webglFramebuffer[Z].length;it++)A.deleteFramebuffer(B.__webglFramebuffer[Z][it]);else A.deleteFramebuffer(B.__webglFramebuffer[Z]);B.__webglDepthbuffer&&A.deleteRenderbuffer(B.__webglDepthbuffer[Z])}else{if(Array.isArray(B.__webglFramebuffer))for(let Z=0;Z<B.__webglFramebuffer.length;Z++)A.deleteFramebuffer(B.__webglFramebuffer[Z]);else A.deleteFramebuffer(B.__webglFramebuffer);if(B.__webglDepthbuffer&&A.deleteRenderbuffer(B.__webglDepthbuffer),B.__webglMultisampledFramebuffer&&A.deleteFramebuffer(B.__webglMultisampledFramebuffer),B.__webglColorRenderbuffer)for(let Z=0;Z<B.__webglColorRenderbuffer.length;Z++)B.__webglColorRenderbuffer[Z]&&A.deleteRenderbuffer(B.__webglColorRenderbuffer[Z]);B.__webglDepthRenderbuffer&&A.deleteRenderbuffer(B.__webglDepthRenderbuffer)}let tt=M.textures;for(let Z=0,it=tt.length;Z<it;Z++){let ct=n.get(tt[Z]);ct.__webglTexture&&(A.deleteTexture(ct.__webglTexture),r.memory.textures--),n.remove(tt[Z])}n.remove(M)}let z=0;function j(){z=0}function $(){return z}function Et(M){z=M}function Pt(){let M=z;return M>=i.maxTextures&&yt("WebGLTextures: Trying to use "+(M+1)+" texture units while this GPU supports only "+i.maxTextures),z+=1,M}function K(M){let B=[];return B.push(M.wrapS),B.push(M.wrapT),B.push(M.wrapR||0),B.push(M.magFilter),B.push(M.minFilter),B.push(M.anisotropy),B.push(M.internalFormat),B.push(M.format),B.push(M.type),B.push(M.generateMipmaps),B.push(M.mipmapsAutoUpdate),B.push(M.premultiplyAlpha),B.push(M.flipY),B.push(M.unpackAlignment),B.push(M.colorSpace),B.join()}function dt(M,B){let U=n.get(M);if(M.isVideoTexture&&le(M),M.isRenderTargetTexture===!1&&M.isExternalTexture!==!0&&M.version>0&&U.__version!==M.version){let tt=M.image;if(tt===null)yt("WebGLRenderer: Texture marked for update but no image data found.");else if(tt.complete===!1)yt("WebGLRenderer: Texture marked for update but image is incomplete");else{ce(U,M,B);return}}else M.isExternalTexture&&(U.__webglTexture=M.sourceTexture?M.sourceTexture:null);e.bindTexture(A.TEXTURE_2D,U.__webglTexture,A.TEXTURE0+B)}function Bt(M,B){let U=n.get(M);if(M.isRenderTargetTexture===!1&&M.version>0&&U.__version!==M.version){ce(U,M,B);return}else M.isExternalTexture&&(U.__webglTexture=M.sourceTexture?M.sourceTexture:null);e.bindTexture(A.TEXTURE_2D_ARRAY,U.__webglTexture,A.TEXTURE0+B)}function xt(M,B){let U=n.get(M);if(M.isRenderTargetTexture===!1&&M.version>0&&U.__version!==M.version){ce(U,M,B);return}e.bindTexture(A.TEXTURE_3D,U.__webglTexture,A.TEXTURE0+B)}function gt(M,B){let U=n.get(M);if(M.version>0&&U.__version!==M.version){Te(U,M,B);return}e.bindTexture(A.TEXTURE_CUBE_MAP,U.__webglTexture,A.TEXTURE0+B)}let Ut={[ss]:A.REPEAT,[an]:A.CLAMP_TO_EDGE,[rs]:A.MIRRORED_REPEAT},re={[me]:A.NEAREST,[sc]:A.NEAREST_MIPMAP_NEAREST,[li]:A.NEAREST_MIPMAP_LINEAR,[Ie]:A.LINEAR,[Rs]:A.LINEAR_MIPMAP_NEAREST,[yn]:A.LINEAR_MIPMAP_LINEAR},St={[cc]:A.NEVER,[bo]:A.ALWAYS,[lc]:A.LESS,[Qo]:A.LEQUAL,[hc]:A.EQUAL,[Io]:A.GEQUAL,[uc]:A.GREATER,[fc]:A.NOTEQUAL};function Kt(M,B){if(B.type===nn&&t.has("OES_texture_float_linear")===!1&&(B.magFilter===Ie||B.magFilter===Rs||B.magFilter===li||B.magFilter===yn||B.minFilter===Ie||B.minFilter===Rs||B.minFilter===li||B.minFilter===yn)&&yt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),A.texParameteri(M,A.TEXTURE_WRAP_S,Ut[B.wrapS]),A.texParameteri(M,A.TEXTURE_WRAP_T,Ut[B.wrapT]),(M===A.TEXTURE_3D||M===A.TEXTURE_2D_ARRAY)&&A.texParameteri(M,A.TEXTURE_WRAP_R,Ut[B.wrapR]),A.texParameteri(M,A.TEXTURE_MAG_FILTER,re[B.magFilter]),A.texParameteri(M,A.TEXTURE_MIN_FILTER,re[B.minFilter]),B.compareFunction&&(A.texParameteri(M,A.TEXTURE_COMPARE_MODE,A.COMPARE_REF_TO_TEXTURE),A.texParameteri(M,A.TEXTURE_COMPARE_FUNC,St[B.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(B.magFilter===me||B.minFilter!==li&&B.minFilter!==yn||B.type===nn&&t.has("OES_texture_float_linear")===!1)return;if(B.anisotropy>1||n.get(B).__currentAnisotropy){let U=t.get("EXT_texture_filter_anisotropic");A.texParameterf(M,U.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(B.anisotropy,i.getMaxAnisotropy())),n.get(B).__currentAnisotropy=B.anisotropy}}}function qt(M,B){let U=!1;M.__webglInit===void 0&&(M.__webglInit=!0,B.addEventListener("dispose",P),N(B));let tt=B.source,Z=d.get(tt);Z===void 0&&(Z={},d.set(tt,Z));let it=K(B);if(it!==M.__cacheKey){Z[it]===void 0&&(Z[it]={texture:A.createTexture(),usedTimes:0},r.memory.textures++,U=!0),Z[it].usedTimes++;let ct=Z[M.__cacheKey];ct!==void 0&&(Z[M.__cacheKey].usedTimes--,ct.usedTimes===0&&G(B)),M.__cacheKey=it,M.__webglTexture=Z[it].texture}return U}function Ht(M,B,U){return Math.floor(Math.floor(M/U)/B)}function Be(M,B,U,tt){let it=M.updateRanges;if(it.length===0)e.texSubImage2D(A.TEXTURE_2D,0,0,0,B.width,B.height,U,tt,B.data);else{it.sort((y,X)=>y.start-X.start);let ct=0;for(let y=1;y<it.length;y++){let X=it[ct],k=it[y],ot=X.start+X.count,At=Ht(k.start,B.width,4),st=Ht(X.start,B.width,4);k.start<=ot+1&&At===st&&Ht(k.start+k.count-1,B.width,4)===At?X.count=Math.max(X.count,k.start+k.count-X.start):(++ct,it[ct]=k)}it.length=ct+1;let Y=e.getParameter(A.UNPACK_ROW_LENGTH),W=e.getParameter(A.UNPACK_SKIP_PIXELS),rt=e.getParameter(A.UNPACK_SKIP_ROWS);e.pixelStorei(A.UNPACK_ROW_LENGTH,B.width);for(let y=0,X=it.length;y<X;y++){let k=it[y],ot=Math.floor(k.start/4),At=Math.ceil(k.count/4),st=ot%B.width,vt=Math.floor(ot/B.width),Lt=At,nt=1;e.pixelStorei(A.UNPACK_SKIP_PIXELS,st),e.pixelStorei(A.UNPACK_SKIP_ROWS,vt),e.texSubImage2D(A.TEXTURE_2D,0,st,vt,Lt,nt,U,tt,B.data)}M.clearUpdateRanges(),e.pixelStorei(A.UNPACK_ROW_LENGTH,Y),e.pixelStorei(A.UNPACK_SKIP_PIXELS,W),e.pixelStorei(A.UNPACK_SKIP_ROWS,rt)}}function ce(M,B,U){let tt=A.TEXTURE_2D;(B.isDataArrayTexture||B.isCompressedArrayTexture)&&(tt=A.TEXTURE_2D_ARRAY),B.isData3DTexture&&(tt=A.TEXTURE_3D);let Z=qt(M,B),it=B.source;e.bindTexture(tt,M.__webglTexture,A.TEXTURE0+U);let ct=n.get(it);if(it.version!==ct.__version||Z===!0){if(e.activeTexture(A.TEXTURE0+U),(typeof ImageBitmap<"u"&&B.image instanceof ImageBitmap)===!1){let nt=kt.getPrimaries(kt.workingColorSpace),Dt=B.colorSpace===Qn?null:kt.getPrimaries(B.colorSpace),Rt=B.colorSpace===Qn||nt===Dt?A.NONE:A.BROWSER_DEFAULT_WEBGL;e.pixelStorei(A.UNPACK_FLIP_Y_WEBGL,B.flipY),e.pixelStorei(A.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),e.pixelStorei(A.UNPACK_COLORSPACE_CONVERSION_WEBGL,Rt)}e.pixelStorei(A.UNPACK_ALIGNMENT,B.unpackAlignment);let W=E(B.image,!1,i.maxTextureSize);W=_t(B,W);let rt=s.convert(B.format,B.colorSpace),y=s.convert(B.type),X=x(B.internalFormat,rt,y,B.normalized,B.colorSpace,B.isVideoTexture);Kt(tt,B);let k,ot=B.mipmaps,At=B.isVideoTexture!==!0,st=ct.__version===void 0||Z===!0,vt=it.dataReady,Lt=v(B,W);if(B.isDepthTexture)X=p(B.format===Sn,B.type),st&&(At?e.texStorage2D(A.TEXTURE_2D,1,X,W.width,W.height):e.texImage2D(A.TEXTURE_2D,0,X,W.width,W.height,0,rt,y,null));else if(B.isDataTexture)if(ot.length>0){At&&st&&e.texStorage2D(A.TEXTURE_2D,Lt,X,ot[0].width,ot[0].height);for(let nt=0,Dt=ot.length;nt<Dt;nt++)k=ot[nt],At?vt&&e.texSubImage2D(A.TEXTURE_2D,nt,0,0,k.width,k.height,rt,y,k.data):e.texImage2D(A.TEXTURE_2D,nt,X,k.width,k.height,0,rt,y,k.data);B.generateMipmaps=!1}else At?(st&&e.texStorage2D(A.TEXTURE_2D,Lt,X,W.width,W.height),vt&&Be(B,W,rt,y)):e.texImage2D(A.TEXTURE_2D,0,X,W.width,W.height,0,rt,y,W.data);else if(B.isCompressedTexture)if(B.isCompressedArrayTexture){At&&st&&e.texStorage3D(A.TEXTURE_2D_ARRAY,Lt,X,ot[0].width,ot[0].height,W.depth);for(let nt=0,Dt=ot.length;nt<Dt;nt++)if(k=ot[nt],B.format!==sn)if(rt!==null)if(At){if(vt)if(B.layerUpdates.size>0){let Rt=No(k.width,k.height,B.format,B.type);for(let ut of B.layerUpdates){let Xt=k.data.subarray(ut*Rt/k.data.BYTES_PER_ELEMENT,(ut+1)*Rt/k.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(A.TEXTURE_2D_ARRAY,nt,0,0,ut,k.width,k.height,1,rt,Xt)}}else e.compressedTexSubImage3D(A.TEXTURE_2D_ARRAY,nt,0,0,0,k.width,k.height,W.depth,rt,k.data)}else e.compressedTexImage3D(A.TEXTURE_2D_ARRAY,nt,X,k.width,k.height,W.depth,0,k.data,0,0);else yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else At?vt&&e.texSubImage3D(A.TEXTURE_2D_ARRAY,nt,0,0,0,k.width,k.height,W.depth,rt,y,k.data):e.texImage3D(A.TEXTURE_2D_ARRAY,nt,X,k.width,k.height,W.depth,0,rt,y,k.data);B.layerUpdates.size>0&&B.clearLayerUpdates()}else{At&&st&&e.texStorage2D(A.TEXTURE_2D,Lt,X,ot[0].width,ot[0].height);for(let nt=0,Dt=ot.length;nt<Dt;nt++)k=ot[nt],B.format!==sn?rt!==null?At?vt&&e.compressedTexSubImage2D(A.TEXTURE_2D,nt,0,0,k.width,k.height,rt,k.data):e.compressedTexImage2D(A.TEXTURE_2D,nt,X,k.width,k.height,0,k.data):yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):At?vt&&e.texSubImage2D(A.TEXTURE_2D,nt,0,0,k.width,k.height,rt,y,k.data):e.texImage2D(A.TEXTURE_2D,nt,X,k.width,k.height,0,rt,y,k.data)}else if(B.isDataArrayTexture)if(At){if(st&&e.texStorage3D(A.TEXTURE_2D_ARRAY,Lt,X,W.width,W.height,W.depth),vt)if(B.layerUpdates.size>0){let nt=No(W.width,W.height,B.format,B.type);for(let Dt of B.layerUpdates){let Rt=W.data.subarray(Dt*nt/W.data.BYTES_PER_ELEMENT,(Dt+1)*nt/W.data.BYTES_PER_ELEMENT);e.texSubImage3D(A.TEXTURE_2D_ARRAY,0,0,0,Dt,W.width,W.height,1,rt,y,Rt)}B.clearLayerUpdates()}else e.texSubImage3D(A.TEXTURE_2D_ARRAY,0,0,0,0,W.width,W.height,W.depth,rt,y,W.data)}else e.texImage3D(A.TEXTURE_2D_ARRAY,0,X,W.width,W.height,W.depth,0,rt,y,W.data);else if(B.isData3DTexture)At?(st&&e.texStorage3D(A.TEXTURE_3D,Lt,X,W.width,W.height,W.depth),vt&&e.texSubImage3D(A.TEXTURE_3D,0,0,0,0,W.width,W.height,W.depth,rt,y,W.data)):e.texImage3D(A.TEXTURE_3D,0,X,W.width,W.height,W.depth,0,rt,y,W.data);else if(B.isFramebufferTexture){if(st)if(At)e.texStorage2D(A.TEXTURE_2D,Lt,X,W.width,W.height);else{let nt=W.width,Dt=W.height;for(let Rt=0;Rt<Lt;Rt++)e.texImage2D(A.TEXTURE_2D,Rt,X,nt,Dt,0,rt,y,null),nt>>=1,Dt>>=1}}else if(B.isHTMLTexture){if("texElementImage2D"in A){let nt=A.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),W.parentNode!==nt){nt.appendChild(W),g.add(B),nt.onpaint=Dt=>{let Rt=Dt.changedElements;for(let ut of g)Rt.includes(ut.image)&&(ut.needsUpdate=!0)},nt.requestPaint();return}if(A.texElementImage2D.length===3)A.texElementImage2D(A.TEXTURE_2D,A.RGBA8,W);else{let Rt=A.RGBA,ut=A.RGBA,Xt=A.UNSIGNED_BYTE;A.texElementImage2D(A.TEXTURE_2D,0,Rt,ut,Xt,W)}A.texParameteri(A.TEXTURE_2D,A.TEXTURE_MIN_FILTER,A.LINEAR),A.texParameteri(A.TEXTURE_2D,A.TEXTURE_WRAP_S,A.CLAMP_TO_EDGE),A.texParameteri(A.TEXTURE_2D,A.TEXTURE_WRAP_T,A.CLAMP_TO_EDGE)}}else if(ot.length>0){if(At&&st){let nt=Tt(ot[0]);e.texStorage2D(A.TEXTURE_2D,Lt,X,nt.width,nt.height)}for(let nt=0,Dt=ot.length;nt<Dt;nt++)k=ot[nt],At?vt&&e.texSubImage2D(A.TEXTURE_2D,nt,0,0,rt,y,k):e.texImage2D(A.TEXTURE_2D,nt,X,rt,y,k);B.generateMipmaps=!1}else if(At){if(st){let nt=Tt(W);e.texStorage2D(A.TEXTURE_2D,Lt,X,nt.width,nt.height)}vt&&e.texSubImage2D(A.TEXTURE_2D,0,0,0,rt,y,W)}else e.texImage2D(A.TEXTURE_2D,0,X,rt,y,W);_(B)&&B.mipmapsAutoUpdate===!0&&D(tt),ct.__version=it.version,B.onUpdate&&B.onUpdate(B)}M.__version=B.version}function Te(M,B,U){if(B.image.length!==6)return;let tt=qt(M,B),Z=B.source;e.bindTexture(A.TEXTURE_CUBE_MAP,M.__webglTexture,A.TEXTURE0+U);let it=n.get(Z);if(Z.version!==it.__version||tt===!0){e.activeTexture(A.TEXTURE0+U);let ct=kt.getPrimaries(kt.workingColorSpace),Y=B.colorSpace===Qn?null:kt.getPrimaries(B.colorSpace),W=B.colorSpace===Qn||ct===Y?A.NONE:A.BROWSER_DEFAULT_WEBGL;e.pixelStorei(A.UNPACK_FLIP_Y_WEBGL,B.flipY),e.pixelStorei(A.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),e.pixelStorei(A.UNPACK_ALIGNMENT,B.unpackAlignment),e.pixelStorei(A.UNPACK_COLORSPACE_CONVERSION_WEBGL,W);let rt=B.isCompressedTexture||B.image[0].isCompressedTexture,y=B.image[0]&&B.image[0].isDataTexture,X=[];for(let ut=0;ut<6;ut++)!rt&&!y?X[ut]=E(B.image[ut],!0,i.maxCubemapSize):X[ut]=y?B.image[ut].image:B.image[ut],X[ut]=_t(B,X[ut]);let k=X[0],ot=s.convert(B.format,B.colorSpace),At=s.convert(B.type),st=x(B.internalFormat,ot,At,B.normalized,B.colorSpace),vt=B.isVideoTexture!==!0,Lt=it.__version===void 0||tt===!0,nt=Z.dataReady,Dt=v(B,k);Kt(A.TEXTURE_CUBE_MAP,B);let Rt;if(B.isDepthTexture){if(st=p(B.format===Sn,B.type),Lt)if(vt)e.texStorage2D(A.TEXTURE_CUBE_MAP,1,st,k.width,k.height);else for(let ut=0;ut<6;ut++)e.texImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,0,st,k.width,k.height,0,ot,At,null)}else if(rt){vt&&Lt&&e.texStorage2D(A.TEXTURE_CUBE_MAP,Dt,st,k.width,k.height);for(let ut=0;ut<6;ut++){Rt=X[ut].mipmaps;for(let Xt=0;Xt<Rt.length;Xt++){let de=Rt[Xt];B.format!==sn?ot!==null?vt?nt&&e.compressedTexSubImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,Xt,0,0,de.width,de.height,ot,de.data):e.compressedTexImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,Xt,st,de.width,de.height,0,de.data):yt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):vt?nt&&e.texSubImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,Xt,0,0,de.width,de.height,ot,At,de.data):e.texImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,Xt,st,de.width,de.height,0,ot,At,de.data)}}}else{if(Rt=B.mipmaps,vt&&Lt){Rt.length>0&&Dt++;let ut=Tt(X[0]);e.texStorage2D(A.TEXTURE_CUBE_MAP,Dt,st,ut.width,ut.height)}for(let ut=0;ut<6;ut++)if(y){vt?nt&&e.texSubImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,0,0,0,X[ut].width,X[ut].height,ot,At,X[ut].data):e.texImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,0,st,X[ut].width,X[ut].height,0,ot,At,X[ut].data);for(let Xt=0;Xt<Rt.length;Xt++){let In=Rt[Xt].image[ut].image;vt?nt&&e.texSubImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,Xt+1,0,0,In.width,In.height,ot,At,In.data):e.texImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,Xt+1,st,In.width,In.height,0,ot,At,In.data)}}else{vt?nt&&e.texSubImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,0,0,0,ot,At,X[ut]):e.texImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,0,st,ot,At,X[ut]);for(let Xt=0;Xt<Rt.length;Xt++){let de=Rt[Xt];vt?nt&&e.texSubImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,Xt+1,0,0,ot,At,de.image[ut]):e.texImage2D(A.TEXTURE_CUBE_MAP_POSITIVE_X+ut,Xt+1,st,ot,At,de.image[ut])}}}_(B)&&B.mipmapsAutoUpdate===!0&&D(A.TEXTURE_CUBE_MAP),it.__version=Z.version,B.onUpdate&&B.onUpdate(B)}M.__version=B.version}function ie(M,B,U,tt,Z,it){let ct=s.convert(U.format,U.colorSpace),Y=s.convert(U.type),W=x(U.internalFormat,ct,Y,U.normalized,U.colorSpace),rt=n.get(B),y=n.get(U);if(y.__renderTarget=B,!rt.__hasExternalTextures){let X=Math.max(1,B.width>>it),k=Math.max(1,B.height>>it);Z===A.TEXTURE_3D||Z===A.TEXTURE_2D_ARRAY?e.texImage3D(Z,it,W,X,k,B.depth,0,ct,Y,null):e.texImage2D(Z,it,W,X,k,0,ct,Y,null)}e.bindFramebuffer(A.FRAMEBUFFER,M),ht(B)?o.framebufferTexture2DMultisampleEXT(A.FRAMEBUFFER,tt,Z,y.__webglTexture,0,ne(B)):(Z===A.TEXTURE_2D||Z>=A.TEXTURE_CUBE_MAP_POSITIVE_X&&Z<=A.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&A.framebufferTexture2D(A.FRAMEBUFFER,tt,Z,y.__webglTexture,it),e.bindFramebuffer(A.FRAMEBUFFER,null)}function rn(M,B,U){if(A.bindRenderbuffer(A.RENDERBUFFER,M),B.depthBuffer){let tt=B.depthTexture,Z=tt&&tt.isDepthTexture?tt.type:null,it=p(B.stencilBuffer,Z),ct=B.stencilBuffer?A.DEPTH_STENCIL_ATTACHMENT:A.DEPTH_ATTACHMENT;ht(B)?o.renderbufferStorageMultisampleEXT(A.RENDERBUFFER,ne(B),it,B.width,B.height):U?A.renderbufferStorageMultisample(A.RENDERBUFFER,ne(B),it,B.width,B.height):A.renderbufferStorage(A.RENDERBUFFER,it,B.width,B.height),A.framebufferRenderbuffer(A.FRAMEBUFFER,ct,A.RENDERBUFFER,M)}else{let tt=B.textures;for(let Z=0;Z<tt.length;Z++){let it=tt[Z],ct=s.convert(it.format,it.colorSpace),Y=s.convert(it.type),W=x(it.internalFormat,ct,Y,it.normalized,it.colorSpace);ht(B)?o.renderbufferStorageMultisampleEXT(A.RENDERBUFFER,ne(B),W,B.width,B.height):U?A.renderbufferStorageMultisample(A.RENDERBUFFER,ne(B),W,B.width,B.height):A.renderbufferStorage(A.RENDERBUFFER,W,B.width,B.height)}}A.bindRenderbuffer(A.RENDERBUFFER,null)}function fe(M,B,U){let tt=B.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(A.FRAMEBUFFER,M),!(B.depthTexture&&B.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Z=n.get(B.depthTexture);Z.__renderTarget=B;let it=tt?B.depthTexture.image[0]:B.depthTexture.image;(!Z.__webglTexture||it.width!==B.width||it.height!==B.height)&&(it.width=B.width,it.height=B.height,B.depthTexture.needsUpdate=!0),tt?gt(B.depthTexture,0):dt(B.depthTexture,0);let ct=Z.__webglTexture,Y=ne(B),W=tt?A.TEXTURE_CUBE_MAP_POSITIVE_X+U:A.TEXTURE_2D,rt=B.depthTexture.format===Sn?A.DEPTH_STENCIL_ATTACHMENT:A.DEPTH_ATTACHMENT;if(B.depthTexture.format===vn)ht(B)?o.framebufferTexture2DMultisampleEXT(A.FRAMEBUFFER,rt,W,ct,0,Y):A.framebufferTexture2D(A.FRAMEBUFFER,rt,W,ct,0);else if(B.depthTexture.format===Sn)ht(B)?o.framebufferTexture2DMultisampleEXT(A.FRAMEBUFFER,rt,W,ct,0,Y):A.framebufferTexture2D(A.FRAMEBUFFER,rt,W,ct,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Ve(M){let B=n.get(M),U=M.isWebGLCubeRenderTarget===!0;if(B.__boundDepthTexture!==M.depthTexture){let tt=M.depthTexture;if(B.__depthDisposeCallback&&B.__depthDisposeCallback(),tt){let Z=()=>{delete B.__boundDepthTexture,delete B.__depthDisposeCallback,tt.removeEventListener("dispose",Z)};tt.addEventListener("dispose",Z),B.__depthDisposeCallback=Z}B.__boundDepthTexture=tt}if(M.depthTexture&&!B.__autoAllocateDepthBuffer)if(U)for(let tt=0;tt<6;tt++)fe(B.__webglFramebuffer[tt],M,tt);else M.texture.mipmaps.length>0?fe(B.__webglFramebuffer[0],M,0):fe(B.__webglFramebuffer,M,0);else if(U){B.__webglDepthbuffer=[];for(let tt=0;tt<6;tt++)if(e.bindFramebuffer(A.FRAMEBUFFER,B.__webglFramebuffer[tt]),B.__webglDepthbuffer[tt]===void 0)B.__webglDepthbuffer[tt]=A.createRenderbuffer(),rn(B.__webglDepthbuffer[tt],M,!1);else{let Z=M.stencilBuffer?A.DEPTH_STENCIL_ATTACHMENT:A.DEPTH_ATTACHMENT,it=B.__webglDepthbuffer[tt];A.bindRenderbuffer(A.RENDERBUFFER,it),A.framebufferRenderbuffer(A.FRAMEBUFFER,Z,A.RENDERBUFFER,it)}}else if(M.texture.mipmaps.length>0?e.bindFramebuffer(A.FRAMEBUFFER,B.__webglFramebuffer[0]):e.bindFramebuffer(A.FRAMEBUFFER,B.__webglFramebuffer),B.__webglDepthbuffer===void 0)B.__webglDepthbuffer=A.createRenderbuffer(),rn(B.__webglDepthbuffer,M,!1);else{let Z=M.stencilBuffer?A.DEPTH_STENCIL_ATTACHMENT:A.DEPTH_ATTACHMENT,it=B.__webglDepthbuffer;A.bindRenderbuffer(A.RENDERBUFFER,it),A.framebufferRenderbuffer(A.FRAMEBUFFER,Z,A.RENDERBUFFER,it)}e.bindFramebuffer(A.FRAMEBUFFER,null)}function Ye(M,B,U){let tt=n.get(M);B!==void 0&&ie(tt.__webglFramebuffer,M,M.texture,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,0),U!==void 0&&Ve(M)}function Je(M){let B=M.texture,U=n.get(M),tt=n.get(B);M.addEventListener("dispose",O),N(M);let Z=M.textures,it=M.isWebGLCubeRenderTarget===!0,ct=Z.length>1;if(ct||(tt.__webglTexture===void 0&&(tt.__webglTexture=A.createTexture()),tt.__version=B.version,r.memory.textures++),it){U.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(B.mipmaps.length>0){U.__webglFramebuffer[Y]=[];for(let W=0;W<B.mipmaps.length;W++)U.__webglFramebuffer[Y][W]=A.createFramebuffer()}else U.__webglFramebuffer[Y]=A.createFramebuffer()}else{if(B.mipmaps.length>0){U.__webglFramebuffer=[];for(let Y=0;Y<B.mipmaps.length;Y++)U.__webglFramebuffer[Y]=A.createFramebuffer()}else U.__webglFramebuffer=A.createFramebuffer();if(ct)for(let Y=0,W=Z.length;Y<W;Y++){let rt=n.get(Z[Y]);rt.__webglTexture===void 0&&(rt.__webglTexture=A.createTexture(),r.memory.textures++)}if(M.samples>0&&ht(M)===!1){U.__webglMultisampledFramebuffer=A.createFramebuffer(),U.__webglColorRenderbuffer=[],e.bindFramebuffer(A.FRAMEBUFFER,U.__webglMultisampledFramebuffer);for(let Y=0;Y<Z.length;Y++){let W=Z[Y];U.__webglColorRenderbuffer[Y]=A.createRenderbuffer(),A.bindRenderbuffer(A.RENDERBUFFER,U.__webglColorRenderbuffer[Y]);let rt=s.convert(W.format,W.colorSpace),y=s.convert(W.type),X=x(W.internalFormat,rt,y,W.normalized,W.colorSpace,M.isXRRenderTarget===!0),k=ne(M);A.renderbufferStorageMultisample(A.RENDERBUFFER,k,X,M.width,M.height),A.framebufferRenderbuffer(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0+Y,A.RENDERBUFFER,U.__webglColorRenderbuffer[Y])}A.bindRenderbuffer(A.RENDERBUFFER,null),M.depthBuffer&&(U.__webglDepthRenderbuffer=A.createRenderbuffer(),rn(U.__webglDepthRenderbuffer,M,!0)),e.bindFramebuffer(A.FRAMEBUFFER,null)}}if(it){e.bindTexture(A.TEXTURE_CUBE_MAP,tt.__webglTexture),Kt(A.TEXTURE_CUBE_MAP,B);for(let Y=0;Y<6;Y++)if(B.mipmaps.length>0)for(let W=0;W<B.mipmaps.length;W++)ie(U.__webglFramebuffer[Y][W],M,B,A.COLOR_ATTACHMENT0,A.TEXTURE_CUBE_MAP_POSITIVE_X+Y,W);else ie(U.__webglFramebuffer[Y],M,B,A.COLOR_ATTACHMENT0,A.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);_(B)?D(A.TEXTURE_CUBE_MAP):B.mipmaps.length>0&&A.texParameteri(A.TEXTURE_CUBE_MAP,A.TEXTURE_MAX_LEVEL,B.mipmaps.length-1),e.unbindTexture()}else if(ct){for(let Y=0,W=Z.length;Y<W;Y++){let rt=Z[Y],y=n.get(rt),X=A.TEXTURE_2D;(M.isWebGL3DRenderTarget||M.isWebGLArrayRenderTarget)&&(X=M.isWebGL3DRenderTarget?A.TEXTURE_3D:A.TEXTURE_2D_ARRAY),e.bindTexture(X,y.__webglTexture),Kt(X,rt),ie(U.__webglFramebuffer,M,rt,A.COLOR_ATTACHMENT0+Y,X,0),_(rt)&&D(X)}e.unbindTexture()}else{let Y=A.TEXTURE_2D;if((M.isWebGL3DRenderTarget||M.isWebGLArrayRenderTarget)&&(Y=M.isWebGL3DRenderTarget?A.TEXTURE_3D:A.TEXTURE_2D_ARRAY),e.bindTexture(Y,tt.__webglTexture),Kt(Y,B),B.mipmaps.length>0)for(let W=0;W<B.mipmaps.length;W++)ie(U.__webglFramebuffer[W],M,B,A.COLOR_ATTACHMENT0,Y,W);else ie(U.__webglFramebuffer,M,B,A.COLOR_ATTACHMENT0,Y,0);_(B)?D(Y):B.mipmaps.length>0&&A.texParameteri(Y,A.TEXTURE_MAX_LEVEL,B.mipmaps.length-1),e.unbindTexture()}M.depthBuffer&&Ve(M)}function T(M){let B=M.textures;for(let U=0,tt=B.length;U<tt;U++){let Z=B[U];if(_(Z)&&Z.mipmapsAutoUpdate===!0){let it=S(M),ct=n.get(Z).__webglTexture;e.bindTexture(it,ct),D(it),e.unbindTexture()}}}let We=[];function ee(M){if(M.samples>0){if(ht(M)===!1){let B=M.textures,U=M.width,tt=M.height,Z=A.COLOR_BUFFER_BIT,it=M.stencilBuffer?A.DEPTH_STENCIL_ATTACHMENT:A.DEPTH_ATTACHMENT,ct=n.get(M),Y=B.length>1;if(Y)for(let rt=0;rt<B.length;rt++)e.bindFramebuffer(A.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),A.framebufferRenderbuffer(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0+rt,A.RENDERBUFFER,null),e.bindFramebuffer(A.FRAMEBUFFER,ct.__webglFramebuffer),A.framebufferTexture2D(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0+rt,A.TEXTURE_2D,null,0);e.bindFramebuffer(A.READ_FRAMEBUFFER,ct.__webglMultisampledFramebuffer),M.texture.mipmaps.length>0?e.bindFramebuffer(A.DRAW_FRAMEBUFFER,ct.__webglFramebuffer[0]):e.bindFramebuffer(A.DRAW_FRAMEBUFFER,ct.__webglFramebuffer);for(let rt=0;rt<B.length;rt++){if(M.resolveDepthBuffer&&(M.depthBuffer&&(Z|=A.DEPTH_BUFFER_BIT),M.stencilBuffer&&M.resolveStencilBuffer&&(Z|=A.STENCIL_BUFFER_BIT)),Y){A.framebufferRenderbuffer(A.READ_FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.RENDERBUFFER,ct.__webglColorRenderbuffer[rt]);let y=n.get(B[rt]).__webglTexture;A.framebufferTexture2D(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0,A.TEXTURE_2D,y,0)}A.blitFramebuffer(0,0,U,tt,0,0,U,tt,Z,A.NEAREST),c===!0&&(We.length=0,We.push(A.COLOR_ATTACHMENT0+rt),M.depthBuffer&&M.storeMultisampledDepthBuffer===!1&&We.push(it),A.invalidateFramebuffer(A.READ_FRAMEBUFFER,We))}if(e.bindFramebuffer(A.READ_FRAMEBUFFER,null),e.bindFramebuffer(A.DRAW_FRAMEBUFFER,null),Y)for(let rt=0;rt<B.length;rt++){e.bindFramebuffer(A.FRAMEBUFFER,ct.__webglMultisampledFramebuffer),A.framebufferRenderbuffer(A.FRAMEBUFFER,A.COLOR_ATTACHMENT0+rt,A.RENDERBUFFER,ct.__webglColorRenderbuffer[rt]);let y=n.get(B[rt]).__webglTexture;e.bindFramebuffer(A.FRAMEBUFFER,ct.__webglFramebuffer),A.framebufferTexture2D(A.DRAW_FRAMEBUFFER,A.COLOR_ATTACHMENT0+rt,A.TEXTURE_2D,y,0)}e.bindFramebuffer(A.DRAW_FRAMEBUFFER,ct.__webglMultisampledFramebuffer)}else if(M.depthBuffer&&M.storeMultisampledDepthBuffer===!1&&c){let B=M.stencilBuffer?A.DEPTH_STENCIL_ATTACHMENT:A.DEPTH_ATTACHMENT;A.invalidateFramebuffer(A.DRAW_FRAMEBUFFER,[B])}}}function ne(M){return Math.min(i.maxSamples,M.samples)}function ht(M){let B=n.get(M);return M.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&B.__useRenderToTexture!==!1}function le(M){let B=r.render.frame;l.get(M)!==B&&(l.set(M,B),M.update())}function _t(M,B){let U=M.colorSpace,tt=M.format,Z=M.type;return M.isCompressedTexture===!0||M.isVideoTexture===!0||U!==kA&&U!==Qn&&(kt.getTransfer(U)===Wt?(tt!==sn||Z!==Ue)&&yt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Qt("WebGLTextures: Unsupported texture color space:",U)),B}function Tt(M){return typeof HTMLImageElement<"u"&&M instanceof HTMLImageElement?(a.width=M.naturalWidth||M.width,a.height=M.naturalHeight||M.height):typeof VideoFrame<"u"&&M instanceof VideoFrame?(a.width=M.displayWidth,a.height=M.displayHeight):(a.width=M.width,a.height=M.height),a}this.allocateTextureUnit=Pt,this.resetTextureUnits=j,this.getTextureUnits=$,this.setTextureUnits=Et,this.setTexture2D=dt,this.setTexture2DArray=Bt,this.setTexture3D=xt,this.setTextureCube=gt,this.rebindTextures=Ye,this.setupRenderTarget=Je,this.updateRenderTargetMipmap=T,this.updateMultisampleRenderTarget=ee,this.setupDepthRenderbuffer=Ve,this.setupFrameBufferTexture=ie,this.useMultisampledRTT=ht,this.dispose=V}function _g(A,t){function e(n,i=Qn){let s,r=kt.getTransfer(i);if(n===Ue)return A.UNSIGNED_BYTE;if(n===Ns)return A.UNSIGNED_SHORT_4_4_4_4;if(n===Hs)return A.UNSIGNED_SHORT_5_5_5_1;if(n===Do)return A.UNSIGNED_INT_5_9_9_9_REV;if(n===xo)return A.UNSIGNED_INT_10F_11F_11F_REV;if(n===Mo)return A.BYTE;if(n===vo)return A.SHORT;if(n===IA)return A.UNSIGNED_SHORT;if(n===Ls)return A.INT;if(n===en)return A.UNSIGNED_INT;if(n===nn)return A.FLOAT;if(n===An)return A.HALF_FLOAT;if(n===_o)return A.ALPHA;if(n===yo)return A.RGB;if(n===sn)return A.RGBA;if(n===vn)return A.DEPTH_COMPONENT;if(n===Sn)return A.DEPTH_STENCIL;if(n===So)return A.RED;if(n===Os)return A.RED_INTEGER;if(n===Vn)return A.RG;if(n===Gs)return A.RG_INTEGER;if(n===ks)return A.RGBA_INTEGER;if(n===hi||n===ui||n===fi||n===di)if(r===Wt)if(s=t.get("WEBGL_compressed_texture_s3tc_srgb"),s!==null){if(n===hi)return s.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===ui)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===fi)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===di)return s.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(s=t.get("WEBGL_compressed_texture_s3tc"),s!==null){if(n===hi)return s.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===ui)return s.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===fi)return s.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===di)return s.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===zs||n===Vs||n===Ys||n===Js)if(s=t.get("WEBGL_compressed_texture_pvrtc"),s!==null){if(n===zs)return s.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Vs)return s.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Ys)return s.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Js)return s.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Ws||n===Ks||n===Xs||n===qs||n===Zs||n===gi||n===js)if(s=t.get("WEBGL_compressed_texture_etc"),s!==null){if(n===Ws||n===Ks)return r===Wt?s.COMPRESSED_SRGB8_ETC2:s.COMPRESSED_RGB8_ETC2;if(n===Xs)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:s.COMPRESSED_RGBA8_ETC2_EAC;if(n===qs)return s.COMPRESSED_R11_EAC;if(n===Zs)return s.COMPRESSED_SIGNED_R11_EAC;if(n===gi)return s.COMPRESSED_RG11_EAC;if(n===js)return s.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===$s||n===tr||n===er||n===nr||n===Ar||n===ir||n===sr||n===rr||n===or||n===ar||n===cr||n===lr||n===hr||n===ur)if(s=t.get("WEBGL_compressed_texture_astc"),s!==null){if(n===$s)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:s.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===tr)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:s.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===er)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:s.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===nr)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:s.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===Ar)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:s.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===ir)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:s.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===sr)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:s.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===rr)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:s.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===or)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:s.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===ar)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:s.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===cr)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:s.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===lr)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:s.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===hr)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:s.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===ur)return r===Wt?s.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:s.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===fr||n===dr||n===gr)if(s=t.get("EXT_texture_compression_bptc"),s!==null){if(n===fr)return r===Wt?s.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:s.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===dr)return s.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===gr)return s.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===pr||n===mr||n===pi||n===Br)if(s=t.get("EXT_texture_compression_rgtc"),s!==null){if(n===pr)return s.COMPRESSED_RED_RGTC1_EXT;if(n===mr)return s.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===pi)return s.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===Br)return s.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===iA?A.UNSIGNED_INT_24_8:A[n]!==void 0?A[n]:null}return{convert:e}}var yg=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,Sg=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Wo=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new $A(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new ln({vertexShader:yg,fragmentShader:Sg,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Fe(new ei(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Ko=class extends cn{constructor(t,e){super();let n=this,i=null,s=1,r=null,o="local-floor",c=1,a=null,l=null,g=null,h=null,d=null,m=null,C=typeof XRWebGLBinding<"u",f=new Wo,u={},E=e.getContextAttributes(),_=null,D=null,S=[],x=[],p=new Vt,v=null,N=null,b=new Qe;b.viewport=new Ae;let P=new Qe;P.viewport=new Ae;let O=[b,P],J=new Ts,I=null,V=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(K){let dt=S[K];return dt===void 0&&(dt=new DA,S[K]=dt),dt.getTargetRaySpace()},this.getControllerGrip=function(K){let dt=S[K];return dt===void 0&&(dt=new DA,S[K]=dt),dt.getGripSpace()},this.getHand=function(K){let dt=S[K];return dt===void 0&&(dt=new DA,S[K]=dt),dt.getHandSpace()};function q(K){let dt=x.indexOf(K.inputSource);if(dt===-1)return;let Bt=S[dt];Bt!==void 0&&(Bt.update(K.inputSource,K.frame,a||r),Bt.dispatchEvent({type:K.type,data:K.inputSource}))}function G(){i.removeEventListener("select",q),i.removeEventListener("selectstart",q),i.removeEventListener("selectend",q),i.removeEventListener("squeeze",q),i.removeEventListener("squeezestart",q),i.removeEventListener("squeezeend",q),i.removeEventListener("end",G),i.removeEventListener("inputsourceschange",et);for(let K=0;K<S.length;K++){let dt=x[K];dt!==null&&(x[K]=null,S[K].disconnect(dt))}I=null,V=null,f.reset();for(let K in u)delete u[K];if(t.setRenderTarget(_),d=null,h=null,g=null,i=null,D=null,Pt.stop(),n.isPresenting=!1,t.setPixelRatio(v),t.setSize(p.width,p.height,!1),N!==null){let K=N.camera;K.fov=N.fov,K.zoom=N.zoom,K.updateProjectionMatrix(),N=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(K){s=K,n.isPresenting===!0&&yt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(K){o=K,n.isPresenting===!0&&yt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return a||r},this.setReferenceSpace=function(K){a=K},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return g===null&&C&&(g=new XRWebGLBinding(i,e)),g},this.getFrame=function(){return m},this.getSession=function(){return i},this.setSession=async function(K){if(i=K,i!==null){if(_=t.getRenderTarget(),i.addEventListener("select",q),i.addEventListener("selectstart",q),i.addEventListener("selectend",q),i.addEventListener("squeeze",q),i.addEventListener("squeezestart",q),i.addEventListener("squeezeend",q),i.addEventListener("end",G),i.addEventListener("inputsourceschange",et),E.xrCompatible!==!0&&await e.makeXRCompatible(),v=t.getPixelRatio(),t.getSize(p),C&&"createProjectionLayer"in XRWebGLBinding.prototype){let Bt=null,xt=null,gt=null;E.depth&&(gt=E.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Bt=E.stencil?Sn:vn,xt=E.stencil?iA:en);let Ut={colorFormat:e.RGBA8,depthFormat:gt,scaleFactor:s};g=this.getBinding(),h=g.createProjectionLayer(Ut),i.updateRenderState({layers:[h]}),t.setPixelRatio(1),t.setSize(h.textureWidth,h.textureHeight,!1),D=new Ge(h.textureWidth,h.textureHeight,{format:sn,type:Ue,depthTexture:new _n(h.textureWidth,h.textureHeight,xt,void 0,void 0,void 0,void 0,void 0,void 0,Bt),stencilBuffer:E.stencil,colorSpace:t.outputColorSpace,samples:E.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let Bt={antialias:E.antialias,alpha:!0,depth:E.depth,stencil:E.stencil,framebufferScaleFactor:s};d=new XRWebGLLayer(i,e,Bt),i.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),D=new Ge(d.framebufferWidth,d.framebufferHeight,{format:sn,type:Ue,colorSpace:t.outputColorSpace,stencilBuffer:E.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}D.isXRRenderTarget=!0,this.setFoveation(c),a=null,r=await i.requestReferenceSpace(o),Pt.setContext(i),Pt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(i!==null)return i.environmentBlendMode},this.getDepthTexture=function(){return f.getDepthTexture()};function et(K){for(let dt=0;dt<K.removed.length;dt++){let Bt=K.removed[dt],xt=x.indexOf(Bt);xt>=0&&(x[xt]=null,S[xt].disconnect(Bt))}for(let dt=0;dt<K.added.length;dt++){let Bt=K.added[dt],xt=x.indexOf(Bt);if(xt===-1){for(let Ut=0;Ut<S.length;Ut++)if(Ut>=x.length){x.push(Bt),xt=Ut;break}else if(x[Ut]===null){x[Ut]=Bt,xt=Ut;break}if(xt===-1)break}let gt=S[xt];gt&&gt.connect(Bt)}}function z(K,dt){dt===null?K.matrixWorld.copy(K.matrix):K.matrixWorld.multiplyMatrices(dt.matrixWorld,K.matrix),K.matrixWorldInverse.copy(K.matrixWorld).invert()}this.updateCamera=function(K){if(i===null)return;let dt=K.near,Bt=K.far;f.texture!==null&&(f.depthNear>0&&(dt=f.depthNear),f.depthFar>0&&(Bt=f.depthFar)),J.near=P.near=b.near=dt,J.far=P.far=b.far=Bt,(I!==J.near||V!==J.far)&&(i.updateRenderState({depthNear:J.near,depthFar:J.far}),I=J.near,V=J.far),J.layers.mask=K.layers.mask|6,b.layers.mask=J.layers.mask&-5,P.layers.mask=J.layers.mask&-3;let xt=K.parent,gt=J.cameras;z(J,xt);for(let Ut=0;Ut<gt.length;Ut++)z(gt[Ut],xt);J.projectionMatrix.copy(b.projectionMatrix),J.projectionMatrixInverse.copy(b.projectionMatrixInverse),N===null&&K.isPerspectiveCamera&&(N={camera:K,fov:K.fov,zoom:K.zoom}),j(K,J,xt)};function j(K,dt,Bt){Bt===null?K.matrix.copy(dt.matrixWorld):(K.matrix.copy(Bt.matrixWorld),K.matrix.invert(),K.matrix.multiply(dt.matrixWorld)),K.matrix.decompose(K.position,K.quaternion,K.scale),K.updateMatrixWorld(!0),K.projectionMatrix.copy(dt.projectionMatrix),K.projectionMatrixInverse.copy(dt.projectionMatrixInverse),K.isPerspectiveCamera&&(K.fov=as*2*Math.atan(1/K.projectionMatrix.elements[5]),K.zoom=1)}this.getCamera=function(){return J},this.getFoveation=function(){if(!(h===null&&d===null))return c},this.setFoveation=function(K){c=K,h!==null&&(h.fixedFoveation=K),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=K)},this.hasDepthSensing=function(){return f.texture!==null},this.getDepthSensingMesh=function(){return f.getMesh(J)},this.getCameraTexture=function(K){return u[K]};let $=null;function Et(K,dt){if(l=dt.getViewerPose(a||r),m=dt,l!==null){let Bt=l.views;d!==null&&(t.setRenderTargetFramebuffer(D,d.framebuffer),t.setRenderTarget(D));let xt=!1;Bt.length!==J.cameras.length&&(J.cameras.length=0,xt=!0);for(let St=0;St<Bt.length;St++){let Kt=Bt[St],qt=null;if(d!==null)qt=d.getViewport(Kt);else{let Be=g.getViewSubImage(h,Kt);qt=Be.viewport,St===0&&(t.setRenderTargetTextures(D,Be.colorTexture,Be.depthStencilTexture),t.setRenderTarget(D))}let Ht=O[St];Ht===void 0&&(Ht=new Qe,Ht.layers.enable(St),Ht.viewport=new Ae,O[St]=Ht),Ht.matrix.fromArray(Kt.transform.matrix),Ht.matrix.decompose(Ht.position,Ht.quaternion,Ht.scale),Ht.projectionMatrix.fromArray(Kt.projectionMatrix),Ht.projectionMatrixInverse.copy(Ht.projectionMatrix).invert(),Ht.viewport.set(qt.x,qt.y,qt.width,qt.height),St===0&&(J.matrix.copy(Ht.matrix),J.matrix.decompose(J.position,J.quaternion,J.scale)),xt===!0&&J.cameras.push(Ht)}let gt=i.enabledFeatures;if(gt&&gt.includes("depth-sensing")&&i.depthUsage=="gpu-optimized"&&C){g=n.getBinding();let St=g.getDepthInformation(Bt[0]);St&&St.isValid&&St.texture&&f.init(St,i.renderState)}if(gt&&gt.includes("camera-access")&&C){t.state.unbindTexture(),g=n.getBinding();for(let St=0;St<Bt.length;St++){let Kt=Bt[St].camera;if(Kt){let qt=u[Kt];qt||(qt=new $A,u[Kt]=qt);let Ht=g.getCameraImage(Kt);qt.sourceTexture=Ht}}}}for(let Bt=0;Bt<S.length;Bt++){let xt=x[Bt],gt=S[Bt];xt!==null&&gt!==void 0&&gt.update(xt,dt,a||r)}$&&$(K,dt),dt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:dt}),m=null}let Pt=new Yc;Pt.setAnimationLoop(Et),this.setAnimationLoop=function(K){$=K},this.dispose=function(){}}},Qg=new te,el=new bt;el.set(-1,0,0,0,1,0,0,0,1);function Ig(A,t){function e(f,u){f.matrixAutoUpdate===!0&&f.updateMatrix(),u.value.copy(f.matrix)}function n(f,u){u.color.getRGB(f.fogColor.value,Uo(A)),u.isFog?(f.fogNear.value=u.near,f.fogFar.value=u.far):u.isFogExp2&&(f.fogDensity.value=u.density)}function i(f,u,E,_,D){u.isNodeMaterial?u.uniformsNeedUpdate=!1:u.isMeshBasicMaterial?s(f,u):u.isMeshLambertMaterial?(s(f,u),u.envMap&&(f.envMapIntensity.value=u.envMapIntensity)):u.isMeshToonMaterial?(s(f,u),g(f,u)):u.isMeshPhongMaterial?(s(f,u),l(f,u),u.envMap&&(f.envMapIntensity.value=u.envMapIntensity)):u.isMeshStandardMaterial?(s(f,u),h(f,u),u.isMeshPhysicalMaterial&&d(f,u,D)):u.isMeshMatcapMaterial?(s(f,u),m(f,u)):u.isMeshDepthMaterial?s(f,u):u.isMeshDistanceMaterial?(s(f,u),C(f,u)):u.isMeshNormalMaterial?s(f,u):u.isLineBasicMaterial?(r(f,u),u.isLineDashedMaterial&&o(f,u)):u.isPointsMaterial?c(f,u,E,_):u.isSpriteMaterial?a(f,u):u.isShadowMaterial?(f.color.value.copy(u.color),f.opacity.value=u.opacity):u.isShaderMaterial&&(u.uniformsNeedUpdate=!1)}function s(f,u){f.opacity.value=u.opacity,u.color&&f.diffuse.value.copy(u.color),u.emissive&&f.emissive.value.copy(u.emissive).multiplyScalar(u.emissiveIntensity),u.map&&(f.map.value=u.map,e(u.map,f.mapTransform)),u.alphaMap&&(f.alphaMap.value=u.alphaMap,e(u.alphaMap,f.alphaMapTransform)),u.bumpMap&&(f.bumpMap.value=u.bumpMap,e(u.bumpMap,f.bumpMapTransform),f.bumpScale.value=u.bumpScale,u.side===be&&(f.bumpScale.value*=-1)),u.normalMap&&(f.normalMap.value=u.normalMap,e(u.normalMap,f.normalMapTransform),f.normalScale.value.copy(u.normalScale),u.side===be&&f.normalScale.value.negate()),u.displacementMap&&(f.displacementMap.value=u.displacementMap,e(u.displacementMap,f.displacementMapTransform),f.displacementScale.value=u.displacementScale,f.displacementBias.value=u.displacementBias),u.emissiveMap&&(f.emissiveMap.value=u.emissiveMap,e(u.emissiveMap,f.emissiveMapTransform)),u.specularMap&&(f.specularMap.value=u.specularMap,e(u.specularMap,f.specularMapTransform)),u.alphaTest>0&&(f.alphaTest.value=u.alphaTest);let E=t.get(u),_=E.envMap,D=E.envMapRotation;_&&(f.envMap.value=_,f.envMapRotation.value.setFromMatrix4(Qg.makeRotationFromEuler(D)).transpose(),_.isCubeTexture&&_.isRenderTargetTexture===!1&&f.envMapRotation.value.premultiply(el),f.reflectivity.value=u.reflectivity,f.ior.value=u.ior,f.refractionRatio.value=u.refractionRatio),u.lightMap&&(f.lightMap.value=u.lightMap,f.lightMapIntensity.value=u.lightMapIntensity,e(u.lightMap,f.lightMapTransform)),u.aoMap&&(f.aoMap.value=u.aoMap,f.aoMapIntensity.value=u.aoMapIntensity,e(u.aoMap,f.aoMapTransform))}function r(f,u){f.diffuse.value.copy(u.color),f.opacity.value=u.opacity,u.map&&(f.map.value=u.map,e(u.map,f.mapTransform))}function o(f,u){f.dashSize.value=u.dashSize,f.totalSize.value=u.dashSize+u.gapSize,f.scale.value=u.scale}function c(f,u,E,_){f.diffuse.value.copy(u.color),f.opacity.value=u.opacity,f.size.value=u.size*E,f.scale.value=_*.5,u.map&&(f.map.value=u.map,e(u.map,f.uvTransform)),u.alphaMap&&(f.alphaMap.value=u.alphaMap,e(u.alphaMap,f.alphaMapTransform)),u.alphaTest>0&&(f.alphaTest.value=u.alphaTest)}function a(f,u){f.diffuse.value.copy(u.color),f.opacity.value=u.opacity,f.rotation.value=u.rotation,u.map&&(f.map.value=u.map,e(u.map,f.mapTransform)),u.alphaMap&&(f.alphaMap.value=u.alphaMap,e(u.alphaMap,f.alphaMapTransform)),u.alphaTest>0&&(f.alphaTest.value=u.alphaTest)}function l(f,u){f.specular.value.copy(u.specular),f.shininess.value=Math.max(u.shininess,1e-4)}function g(f,u){u.gradientMap&&(f.gradientMap.value=u.gradientMap)}function h(f,u){f.metalness.value=u.metalness,u.metalnessMap&&(f.metalnessMap.value=u.metalnessMap,e(u.metalnessMap,f.metalnessMapTransform)),f.roughness.value=u.roughness,u.roughnessMap&&(f.roughnessMap.value=u.roughnessMap,e(u.roughnessMap,f.roughnessMapTransform)),u.envMap&&(f.envMapIntensity.value=u.envMapIntensity)}function d(f,u,E){f.ior.value=u.ior,u.diffuseRoughness>0&&(f.diffuseRoughness.value=u.diffuseRoughness,u.diffuseRoughnessMap&&(f.diffuseRoughnessMap.value=u.diffuseRoughnessMap,e(u.diffuseRoughnessMap,f.diffuseRoughnessMapTransform))),u.sheen>0&&(f.sheenColor.value.copy(u.sheenColor).multiplyScalar(u.sheen),f.sheenRoughness.value=u.sheenRoughness,u.sheenColorMap&&(f.sheenColorMap.value=u.sheenColorMap,e(u.sheenColorMap,f.sheenColorMapTransform)),u.sheenRoughnessMap&&(f.sheenRoughnessMap.value=u.sheenRoughnessMap,e(u.sheenRoughnessMap,f.sheenRoughnessMapTransform))),u.clearcoat>0&&(f.clearcoat.value=u.clearcoat,f.clearcoatRoughness.value=u.clearcoatRoughness,u.clearcoatMap&&(f.clearcoatMap.value=u.clearcoatMap,e(u.clearcoatMap,f.clearcoatMapTransform)),u.clearcoatRoughnessMap&&(f.clearcoatRoughnessMap.value=u.clearcoatRoughnessMap,e(u.clearcoatRoughnessMap,f.clearcoatRoughnessMapTransform)),u.clearcoatNormalMap&&(f.clearcoatNormalMap.value=u.clearcoatNormalMap,e(u.clearcoatNormalMap,f.clearcoatNormalMapTransform),f.clearcoatNormalScale.value.copy(u.clearcoatNormalScale),u.side===be&&f.clearcoatNormalScale.value.negate())),u.dispersion>0&&(f.dispersion.value=u.dispersion),u.retroreflectivity>0&&(f.retroreflectivity.value=u.retroreflectivity),u.iridescence>0&&(f.iridescence.value=u.iridescence,f.iridescenceIOR.value=u.iridescenceIOR,f.iridescenceThicknessMinimum.value=u.iridescenceThicknessMinimum,f.iridescenceThicknessMaximum.value=u.iridescenceThicknessMaximum,u.iridescenceMap&&(f.iridescenceMap.value=u.iridescenceMap,e(u.iridescenceMap,f.iridescenceMapTransform)),u.iridescenceThicknessMap&&(f.iridescenceThicknessMap.value=u.iridescenceThicknessMap,e(u.iridescenceThicknessMap,f.iridescenceThicknessMapTransform))),u.transmission>0&&(f.transmission.value=u.transmission,f.transmissionSamplerMap.value=E.texture,f.transmissionSamplerSize.value.set(E.width,E.height),u.transmissionMap&&(f.transmissionMap.value=u.transmissionMap,e(u.transmissionMap,f.transmissionMapTransform)),f.thickness.value=u.thickness,u.thicknessMap&&(f.thicknessMap.value=u.thicknessMap,e(u.thicknessMap,f.thicknessMapTransform)),f.attenuationDistance.value=u.attenuationDistance,f.attenuationColor.value.copy(u.attenuationColor)),u.anisotropy>0&&(f.anisotropyVector.value.set(u.anisotropy*Math.cos(u.anisotropyRotation),u.anisotropy*Math.sin(u.anisotropyRotation)),u.anisotropyMap&&(f.anisotropyMap.value=u.anisotropyMap,e(u.anisotropyMap,f.anisotropyMapTransform))),f.specularIntensity.value=u.specularIntensity,f.specularColor.value.copy(u.specularColor),u.specularColorMap&&(f.specularColorMap.value=u.specularColorMap,e(u.specularColorMap,f.specularColorMapTransform)),u.specularIntensityMap&&(f.specularIntensityMap.value=u.specularIntensityMap,e(u.specularIntensityMap,f.specularIntensityMapTransform))}function m(f,u){u.matcap&&(f.matcap.value=u.matcap)}function C(f,u){let E=t.get(u).light;f.referencePosition.value.setFromMatrixPosition(E.matrixWorld),f.nearDistance.value=E.shadow.camera.near,f.farDistance.value=E.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:i}}function bg(A,t,e,n){let i={},s={};function r(E,_){let D=_.program;n.uniformBlockBinding(E,D,i[E.id])}function o(E,_){let D=i[E.id];D===void 0&&(m(E),D=c(E),i[E.id]=D,E.addEventListener("dispose",f));let S=_.program;n.updateUBOMapping(E,S);let x=t.render.frame;s[E.id]!==x&&(a(E),s[E.id]=x)}function c(E){let _=A.createBuffer(),D=E.__size,S=E.usage;return A.bindBuffer(A.UNIFORM_BUFFER,_),A.bufferData(A.UNIFORM_BUFFER,D,S),A.bindBuffer(A.UNIFORM_BUFFER,null),_}function a(E){let _=i[E.id],D=E.uniforms,S=E.__cache;A.bindBuffer(A.UNIFORM_BUFFER,_);for(let x=0,p=D.length;x<p;x++){let v=D[x];if(Array.isArray(v))for(let N=0,b=v.length;N<b;N++)l(v[N],x,N,S);else l(v,x,0,S)}A.bindBuffer(A.UNIFORM_BUFFER,null)}function l(E,_,D,S){if(h(E,_,D,S)===!0){let x=E.__offset,p=E.value;if(Array.isArray(p)){let v=0;for(let N=0;N<p.length;N++){let b=p[N],P=C(b,!0);g(b,E.__data,v),v+=P.storage/Float32Array.BYTES_PER_ELEMENT}}else g(p,E.__data,0);A.bufferSubData(A.UNIFORM_BUFFER,x,E.__data)}}function g(E,_,D){typeof E=="number"||typeof E=="boolean"?_[D]=E:E.isMatrix3?(_[D]=E.elements[0],_[D+1]=E.elements[1],_[D+2]=E.elements[2],_[D+3]=0,_[D+4]=E.elements[3],_[D+5]=E.elements[4],_[D+6]=E.elements[5],_[D+7]=0,_[D+8]=E.elements[6],_[D+9]=E.elements[7],_[D+10]=E.elements[8],_[D+11]=0):ArrayBuffer.isView(E)?_.set(E.subarray(0,_.length-D),D):E.toArray(_,D)}function h(E,_,D,S){let x=E.value,p=_+"_"+D;if(Array.isArray(x)){S[p]===void 0&&(S[p]=[]);let v=S[p],N=!1;for(let b=0;b<x.length;b++)d(x[b],v,b)===!0&&(N=!0);return N}return d(x,S,p)}function d(E,_,D){if(_[D]===void 0)return typeof E=="number"||typeof E=="boolean"?_[D]=E:ArrayBuffer.isView(E)?_[D]=E.slice():_[D]=E.clone(),!0;{let S=_[D];if(typeof E=="number"||typeof E=="boolean"){if(S!==E)return _[D]=E,!0}else{if(ArrayBuffer.isView(E))return!0;if(S.equals(E)===!1)return S.copy(E),!0}}return!1}function m(E){let _=E.uniforms,D=0,S=16;for(let p=0,v=_.length;p<v;p++){let N=Array.isArray(_[p])?_[p]:[_[p]];for(let b=0,P=N.length;b<P;b++){let O=N[b],J=Array.isArray(O.value)?O.value:[O.value],I=Array.isArray(_[p])||Array.isArray(O.value),V=D;for(let G=0,et=J.length;G<et;G++){let z=J[G],j=C(z,I),$=D%S,Et=$%j.boundary,Pt=$+Et;D+=Et,Pt!==0&&S-Pt<j.storage&&(D+=S-Pt),G===0&&(V=D),D+=j.storage}let q=O.type==="int"?Int32Array:O.type==="uint"?Uint32Array:Float32Array;O.__data=new q((D-V)/Float32Array.BYTES_PER_ELEMENT),O.__offset=V}}let x=D%S;return x>0&&(D+=S-x),E.__size=D,E.__cache={},this}function C(E,_){let D={boundary:0,storage:0};return typeof E=="number"||typeof E=="boolean"?(D.boundary=4,D.storage=4):E.isVector2?(D.boundary=8,D.storage=8):E.isVector3||E.isColor?(D.boundary=16,D.storage=12):E.isVector4?(D.boundary=16,D.storage=16):E.isMatrix3?(D.boundary=16,D.storage=48):E.isMatrix4?(D.boundary=16,D.storage=64):E.isTexture?yt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(E)?(D.boundary=16,D.storage=E.byteLength):yt("WebGLRenderer: Unsupported uniform value type.",E),_===!0&&(D.boundary=16,D.storage=Math.ceil(D.storage/16)*16),D}function f(E){let _=E.target;_.removeEventListener("dispose",f),A.deleteBuffer(i[_.id]),delete i[_.id],delete s[_.id]}function u(){for(let E in i)A.deleteBuffer(i[E]);i={},s={}}return{bind:r,update:o,dispose:u}}var Tg=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),fn=null;function Pg(){return fn===null&&(fn=new fs(Tg,16,16,Vn,An),fn.name="DFG_LUT",fn.minFilter=Ie,fn.magFilter=Ie,fn.wrapS=an,fn.wrapT=an,fn.generateMipmaps=!1,fn.needsUpdate=!0),fn}var vr=class{constructor(t={}){let{canvas:e=gc(),context:n=null,depth:i=!0,stencil:s=!1,alpha:r=!1,antialias:o=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:a=!1,powerPreference:l="default",failIfMajorPerformanceCaveat:g=!1,reversedDepthBuffer:h=!1,outputBufferType:d=Ue}=t;this.isWebGLRenderer=!0;let m;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");m=n.getContextAttributes().alpha}else m=r;let C=d,f=new Set([ks,Gs,Os]),u=new Set([Ue,en,IA,iA,Ns,Hs]),E=new Uint32Array(4),_=new Int32Array(4),D={textures:[],min:[],max:[],resolution:[]},S=null,x=null,p=[],v=[],N=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=un,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let b=this,P=!1,O=null,J=null,I=null,V=null;this._outputColorSpace=Ce;let q=0,G=0,et=null,z=-1,j=null,$=new Ae,Et=new Ae,Pt=null,K=new It(0),dt=0,Bt=e.width,xt=e.height,gt=1,Ut=null,re=null,St=new Ae(0,0,Bt,xt),Kt=new Ae(0,0,Bt,xt),qt=!1,Ht=new Nn,Be=new ds,ce=!1,Te=!1,ie=new te,rn=new R,fe=new Ae,Ve={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ye=!1;function Je(){return et===null?gt:1}let T=n;function We(w,Q){return e.getContext(w,Q)}let ee,ne,ht,le,_t,Tt,M,B,U,tt,Z,it,ct,Y,W,rt,y,X,k,ot,At,st,vt;try{let w={alpha:!0,depth:i,stencil:s,antialias:o,premultipliedAlpha:c,preserveDrawingBuffer:a,powerPreference:l,failIfMajorPerformanceCaveat:g};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Dt,!1),e.addEventListener("webglcontextrestored",Rt,!1),e.addEventListener("webglcontextcreationerror",ut,!1),T===null){let Q="webgl2";if(T=We(Q,w),T===null)throw We(Q)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Lt()}catch(w){throw e.removeEventListener("webglcontextlost",Dt,!1),e.removeEventListener("webglcontextrestored",Rt,!1),e.removeEventListener("webglcontextcreationerror",ut,!1),Qt("WebGLRenderer: "+w.message),w}function Lt(){ee=new Vf(T),ee.init(),At=new _g(T,ee),ne=new Pf(T,ee,t,At),ht=new Dg(T,ee),ne.reversedDepthBuffer&&h&&ht.buffers.depth.setReversed(!0),J=T.createFramebuffer(),I=T.createFramebuffer(),V=T.createFramebuffer(),le=new Wf(T),_t=new lg,Tt=new xg(T,ee,ht,_t,ne,At,le),M=new zf(b),B=new Kl(T),st=new bf(T,B),U=new Yf(T,B,le,st),tt=new Xf(T,U,B,st,le),X=new Kf(T,ne,Tt),W=new Ff(_t),Z=new cg(b,M,ee,ne,st,W),it=new Ig(b,_t),ct=new ug,Y=new Bg(ee),y=new If(b,M,ht,tt,m,c),rt=new vg(b,tt,ne),vt=new bg(T,le,ne,ht),k=new Tf(T,ee,le),ot=new Jf(T,ee,le),le.programs=Z.programs,b.capabilities=ne,b.extensions=ee,b.properties=_t,b.renderLists=ct,b.shadowMap=rt,b.state=ht,b.info=le}C!==Ue&&(N=new Zf(C,e.width,e.height,o,i,s));let nt=new Ko(b,T);this.xr=nt,this.getContext=function(){return T},this.getContextAttributes=function(){return T.getContextAttributes()},this.forceContextLoss=function(){let w=ee.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=ee.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return gt},this.setPixelRatio=function(w){w!==void 0&&(gt=w,this.setSize(Bt,xt,!1))},this.getSize=function(w){return w.set(Bt,xt)},this.setSize=function(w,Q,H=!0){if(nt.isPresenting){yt("WebGLRenderer: Can't change size while VR device is presenting.");return}Bt=w,xt=Q,e.width=Math.floor(w*gt),e.height=Math.floor(Q*gt),H===!0&&(e.style.width=w+"px",e.style.height=Q+"px"),N!==null&&N.setSize(e.width,e.height),this.setViewport(0,0,w,Q)},this.getDrawingBufferSize=function(w){return w.set(Bt*gt,xt*gt).floor()},this.setDrawingBufferSize=function(w,Q,H){Bt=w,xt=Q,gt=H,e.width=Math.floor(w*H),e.height=Math.floor(Q*H),this.setViewport(0,0,w,Q)},this.setEffects=function(w){if(C===Ue){Qt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let Q=0;Q<w.length;Q++)if(w[Q].isOutputPass===!0){yt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}N.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy($)},this.getViewport=function(w){return w.copy(St)},this.setViewport=function(w,Q,H,F){w.isVector4?St.set(w.x,w.y,w.z,w.w):St.set(w,Q,H,F),ht.viewport($.copy(St).multiplyScalar(Je()).round())},this.getScissor=function(w){return w.copy(Kt)},this.setScissor=function(w,Q,H,F){w.isVector4?Kt.set(w.x,w.y,w.z,w.w):Kt.set(w,Q,H,F),ht.scissor(Et.copy(Kt).multiplyScalar(Je()).round())},this.getScissorTest=function(){return qt},this.setScissorTest=function(w){ht.setScissorTest(qt=w)},this.setOpaqueSort=function(w){Ut=w},this.setTransparentSort=function(w){re=w},this.getClearColor=function(w){return w.copy(y.getClearColor())},this.setClearColor=function(){y.setClearColor(...arguments)},this.getClearAlpha=function(){return y.getClearAlpha()},this.setClearAlpha=function(){y.setClearAlpha(...arguments)},this.clear=function(w=!0,Q=!0,H=!0){let F=0;if(w){let L=!1;if(et!==null){let lt=et.texture.format;L=f.has(lt)}if(L){let lt=et.texture.type,mt=u.has(lt),at=y.getClearColor(),pt=y.getClearAlpha(),Mt=at.r,Ft=at.g,Ot=at.b;mt?(E[0]=Mt,E[1]=Ft,E[2]=Ot,E[3]=pt,T.clearBufferuiv(T.COLOR,0,E)):(_[0]=Mt,_[1]=Ft,_[2]=Ot,_[3]=pt,T.clearBufferiv(T.COLOR,0,_))}else F|=T.COLOR_BUFFER_BIT}Q&&(F|=T.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),H&&(F|=T.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&T.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),O=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Dt,!1),e.removeEventListener("webglcontextrestored",Rt,!1),e.removeEventListener("webglcontextcreationerror",ut,!1),y.dispose(),ct.dispose(),Y.dispose(),Tt.dispose(),_t.dispose(),M.dispose(),tt.dispose(),U.dispose(),st.dispose(),vt.dispose(),Z.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",$o),nt.removeEventListener("sessionend",ta),Yn.stop()};function Dt(w){w.preventDefault(),Po("WebGLRenderer: Context Lost."),P=!0}function Rt(){Po("WebGLRenderer: Context Restored."),P=!1;let w=le.autoReset,Q=rt.enabled,H=rt.autoUpdate,F=rt.needsUpdate,L=rt.type;Lt(),le.autoReset=w,rt.enabled=Q,rt.autoUpdate=H,rt.needsUpdate=F,rt.type=L}function ut(w){Qt("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function Xt(w){let Q=w.target;Q.removeEventListener("dispose",Xt),de(Q)}function de(w){In(w),_t.remove(w)}function In(w){let Q=_t.get(w).programs;Q!==void 0&&(Q.forEach(function(H){Z.releaseProgram(H)}),w.isShaderMaterial&&Z.releaseShaderCache(w))}this.renderBufferDirect=function(w,Q,H,F,L,lt){Q===null&&(Q=Ve);let mt=L.isMesh&&L.matrixWorld.determinantAffine()<0,at=ol(w,Q,H,F,L);ht.setMaterial(F,mt);let pt=H.index,Mt=1;if(F.wireframe===!0){if(pt=U.getWireframeAttribute(H),pt===void 0)return;Mt=2}let Ft=H.drawRange,Ot=H.attributes.position,wt=Ft.start*Mt,Gt=(Ft.start+Ft.count)*Mt;lt!==null&&(wt=Math.max(wt,lt.start*Mt),Gt=Math.min(Gt,(lt.start+lt.count)*Mt)),pt!==null?(wt=Math.max(wt,0),Gt=Math.min(Gt,pt.count)):Ot!=null&&(wt=Math.max(wt,0),Gt=Math.min(Gt,Ot.count));let oe=Gt-wt;if(oe<0||oe===1/0)return;st.setup(L,F,at,H,pt);let jt,Zt=k;if(pt!==null&&(jt=B.get(pt),Zt=ot,Zt.setIndex(jt)),L.isMesh)F.wireframe===!0?(ht.setLineWidth(F.wireframeLinewidth*Je()),Zt.setMode(T.LINES)):Zt.setMode(T.TRIANGLES);else if(L.isLine){let ve=F.linewidth;ve===void 0&&(ve=1),ht.setLineWidth(ve*Je()),L.isLineSegments?Zt.setMode(T.LINES):L.isLineLoop?Zt.setMode(T.LINE_LOOP):Zt.setMode(T.LINE_STRIP)}else L.isPoints?Zt.setMode(T.POINTS):L.isSprite&&Zt.setMode(T.TRIANGLES);if(L.isBatchedMesh)if(ee.get("WEBGL_multi_draw"))Zt.renderMultiDraw(L._multiDrawStarts,L._multiDrawCounts,L._multiDrawCount);else{let ve=L._multiDrawStarts,Ct=L._multiDrawCounts,Se=L._multiDrawCount,Jt=pt?B.get(pt).bytesPerElement:1,Jn=_t.get(F).currentProgram.getUniforms();for(let De=0;De<Se;De++)Jn.setValue(T,"_gl_DrawID",De),Zt.render(ve[De]/Jt,Ct[De])}else if(L.isInstancedMesh)Zt.renderInstances(wt,oe,L.count);else if(H.isInstancedBufferGeometry){let ve=H._maxInstanceCount!==void 0?H._maxInstanceCount:1/0,Ct=Math.min(H.instanceCount,ve);Zt.renderInstances(wt,oe,Ct)}else Zt.render(wt,oe)};function jo(w,Q,H,F){O!==null&&w.isNodeMaterial&&O.setObject(F,w),ce===!0&&W.setState(w,H,!1),w.transparent===!0&&w.side===hn&&w.forceSinglePass===!1?(w.side=be,w.needsUpdate=!0,FA(w,Q,F),w.side=zn,w.needsUpdate=!0,FA(w,Q,F),w.side=hn):FA(w,Q,F)}this.compile=function(w,Q,H=null){H===null&&(H=w),O!==null&&O.renderStart(w,Q,H),x=Y.get(H),x.init(Q),v.push(x),H.traverseVisible(function(L){L.isLight&&L.layers.test(Q.layers)&&(x.pushLight(L),L.castShadow&&x.pushShadow(L))}),w!==H&&w.traverseVisible(function(L){L.isLight&&L.layers.test(Q.layers)&&(x.pushLight(L),L.castShadow&&x.pushShadow(L))}),x.setupLights(),O!==null&&O.updateLights(x.state.lightsArray),Te=this.localClippingEnabled,ce=W.init(this.clippingPlanes,Te),ce===!0&&W.setGlobalState(this.clippingPlanes,Q),O!==null&&rt.render(x.state.shadowsArray,H,Q);let F=new Set;return w.traverse(function(L){if(!(L.isMesh||L.isPoints||L.isLine||L.isSprite))return;let lt=L.material;if(lt)if(Array.isArray(lt))for(let mt=0;mt<lt.length;mt++){let at=lt[mt];jo(at,H,Q,L),F.add(at)}else jo(lt,H,Q,L),F.add(lt)}),x=v.pop(),O!==null&&O.renderEnd(),F},this.compileAsync=function(w,Q,H=null){let F=this.compile(w,Q,H);return new Promise(L=>{function lt(){if(F.forEach(function(mt){let pt=_t.get(mt).currentProgram;(pt===void 0||pt.isReady())&&F.delete(mt)}),F.size===0){L(w);return}setTimeout(lt,10)}ee.get("KHR_parallel_shader_compile")!==null?lt():setTimeout(lt,10)})};let Qr=null;function sl(w){Qr&&Qr(w)}function $o(){Yn.stop()}function ta(){Yn.start()}let Yn=new Yc;Yn.setAnimationLoop(sl),typeof self<"u"&&Yn.setContext(self),this.setAnimationLoop=function(w){Qr=w,nt.setAnimationLoop(w),w===null?Yn.stop():Yn.start()},nt.addEventListener("sessionstart",$o),nt.addEventListener("sessionend",ta),this.render=function(w,Q){if(Q!==void 0&&Q.isCamera!==!0){Qt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(P===!0)return;O!==null&&O.renderStart(w,Q);let H=nt.enabled===!0&&nt.isPresenting===!0,F=N!==null&&(et===null||H)&&N.begin(b,et);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),Q.parent===null&&Q.matrixWorldAutoUpdate===!0&&Q.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(N===null||N.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(Q),Q=nt.getCamera()),w.isScene===!0&&w.onBeforeRender(b,w,Q,et),x=Y.get(w,v.length),x.init(Q),x.state.textureUnits=Tt.getTextureUnits(),v.push(x),ie.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),Q.isArrayCamera?Be.setFromArrayCamera(Q):Ht.setFromProjectionMatrix(ie,Xe,Q.reversedDepth),Te=this.localClippingEnabled,ce=W.init(this.clippingPlanes,Te),S=ct.get(w,p.length),S.init(),p.push(S),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){let mt=b.xr.getDepthSensingMesh();mt!==null&&Ir(mt,Q,-1/0,b.sortObjects)}Ir(w,Q,0,b.sortObjects),S.finish(),O!==null&&O.updateLights(x.state.lightsArray),b.sortObjects===!0&&S.sort(Ut,re),Ye=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Ye&&y.addToRenderList(S,w),this.info.autoReset===!0&&this.info.reset(),ce===!0&&W.beginShadows();let L=x.state.shadowsArray;if(rt.render(L,w,Q),ce===!0&&W.endShadows(),(F&&N.hasRenderPass())===!1){let mt=S.opaque,at=S.transmissive;if(x.setupLights(),Q.isArrayCamera){let pt=Q.cameras;if(at.length>0)for(let Mt=0,Ft=pt.length;Mt<Ft;Mt++){let Ot=pt[Mt];na(mt,at,w,Ot)}Ye&&y.render(w);for(let Mt=0,Ft=pt.length;Mt<Ft;Mt++){let Ot=pt[Mt];ea(S,w,Ot,Ot.viewport)}}else at.length>0&&na(mt,at,w,Q),Ye&&y.render(w),ea(S,w,Q)}et!==null&&G===0&&(Tt.updateMultisampleRenderTarget(et),Tt.updateRenderTargetMipmap(et)),F&&N.end(b),w.isScene===!0&&w.onAfterRender(b,w,Q),st.resetDefaultState(),z=-1,j=null,v.pop(),v.length>0?(x=v[v.length-1],Tt.setTextureUnits(x.state.textureUnits),ce===!0&&W.setGlobalState(b.clippingPlanes,x.state.camera)):x=null,p.pop(),p.length>0?S=p[p.length-1]:S=null,O!==null&&O.renderEnd()};function Ir(w,Q,H,F){if(w.visible===!1)return;if(w.layers.test(Q.layers)){if(w.isGroup)H=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(Q);else if(w.isLight)x.pushLight(w),w.castShadow&&x.pushShadow(w);else if(w.isSprite){let mt=Q.isArrayCamera?Be:Ht;if(!w.frustumCulled||w.intersectsFrustum(mt)){F&&fe.setFromMatrixPosition(w.matrixWorld).applyMatrix4(ie);let at=tt.update(w),pt=w.material;pt.visible&&S.push(w,at,pt,H,fe.z,null,Q)}}else if(w.isMesh||w.isLine||w.isPoints){let mt=Q.isArrayCamera?Be:Ht;if(!w.frustumCulled||w.intersectsFrustum(mt)){let at=tt.update(w),pt=w.material;if(F&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),fe.copy(w.boundingSphere.center)):(at.boundingSphere===null&&at.computeBoundingSphere(),fe.copy(at.boundingSphere.center)),fe.applyMatrix4(w.matrixWorld).applyMatrix4(ie)),Array.isArray(pt)){let Mt=at.groups;for(let Ft=0,Ot=Mt.length;Ft<Ot;Ft++){let wt=Mt[Ft],Gt=pt[wt.materialIndex];Gt&&Gt.visible&&S.push(w,at,Gt,H,fe.z,wt,Q)}}else pt.visible&&S.push(w,at,pt,H,fe.z,null,Q)}}}let lt=w.children;for(let mt=0,at=lt.length;mt<at;mt++)Ir(lt[mt],Q,H,F)}function ea(w,Q,H,F){let{opaque:L,transmissive:lt,transparent:mt}=w;x.setupLightsView(H),ce===!0&&W.setGlobalState(b.clippingPlanes,H),F&&ht.viewport($.copy(F)),L.length>0&&Mi(L,Q,H),lt.length>0&&Mi(lt,Q,H),mt.length>0&&Mi(mt,Q,H),ht.buffers.depth.setTest(!0),ht.buffers.depth.setMask(!0),ht.buffers.color.setMask(!0),ht.setPolygonOffset(!1)}function na(w,Q,H,F){if((H.isScene===!0?H.overrideMaterial:null)!==null)return;if(x.state.transmissionRenderTarget[F.id]===void 0){let wt=ee.has("EXT_color_buffer_half_float")||ee.has("EXT_color_buffer_float");x.state.transmissionRenderTarget[F.id]=new Ge(1,1,{generateMipmaps:!0,type:wt?An:Ue,minFilter:yn,samples:Math.max(4,ne.samples),stencilBuffer:s,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:kt.workingColorSpace})}let lt=x.state.transmissionRenderTarget[F.id],mt=F.viewport||$;lt.setSize(mt.z*b.transmissionResolutionScale,mt.w*b.transmissionResolutionScale);let at=b.getRenderTarget(),pt=b.getActiveCubeFace(),Mt=b.getActiveMipmapLevel();b.setRenderTarget(lt),b.getClearColor(K),dt=b.getClearAlpha(),dt<1&&b.setClearColor(16777215,.5),b.clear(),Ye&&y.render(H);let Ft=b.toneMapping;b.toneMapping=un;let Ot=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),x.setupLightsView(F),ce===!0&&W.setGlobalState(b.clippingPlanes,F),Mi(w,H,F),Tt.updateMultisampleRenderTarget(lt),Tt.updateRenderTargetMipmap(lt),ee.has("WEBGL_multisampled_render_to_texture")===!1){let wt=!1;for(let Gt=0,oe=Q.length;Gt<oe;Gt++){let jt=Q[Gt],{object:Zt,geometry:ve,material:Ct,group:Se}=jt;if(Ct.side===hn&&Zt.layers.test(F.layers)){let Jt=Ct.side;Ct.side=be,Ct.needsUpdate=!0,Aa(Zt,H,F,ve,Ct,Se),Ct.side=Jt,Ct.needsUpdate=!0,wt=!0}}wt===!0&&(Tt.updateMultisampleRenderTarget(lt),Tt.updateRenderTargetMipmap(lt))}b.setRenderTarget(at,pt,Mt),b.setClearColor(K,dt),Ot!==void 0&&(F.viewport=Ot),b.toneMapping=Ft}function Mi(w,Q,H){let F=Q.isScene===!0?Q.overrideMaterial:null;for(let L=0,lt=w.length;L<lt;L++){let mt=w[L],{object:at,geometry:pt,group:Mt}=mt,Ft=mt.material;Ft.allowOverride===!0&&F!==null&&(Ft=F),at.layers.test(H.layers)&&Aa(at,Q,H,pt,Ft,Mt)}}function Aa(w,Q,H,F,L,lt){O!==null&&L.isNodeMaterial&&O.setObject(w,L),w.onBeforeRender(b,Q,H,F,L,lt),w.modelViewMatrix.multiplyMatrices(H.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),L.onBeforeRender(b,Q,H,F,w,lt),L.transparent===!0&&L.side===hn&&L.forceSinglePass===!1?(L.side=be,L.needsUpdate=!0,b.renderBufferDirect(H,Q,F,L,w,lt),L.side=zn,L.needsUpdate=!0,b.renderBufferDirect(H,Q,F,L,w,lt),L.side=hn):b.renderBufferDirect(H,Q,F,L,w,lt),w.onAfterRender(b,Q,H,F,L,lt)}function ia(w){let Q=0;for(let H of w)H.texture!==null&&Q++;return Q}function FA(w,Q,H){Q.isScene!==!0&&(Q=Ve);let F=_t.get(w),L=x.state.lights,lt=x.state.shadowsArray,mt=L.state.version,at=Z.getParameters(w,L.state,lt,Q,H,x.state.lightProbeGridArray),pt=Z.getProgramCacheKey(at),Mt=F.programs;F.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?Q.environment:null,F.fog=Q.fog;let Ft=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;F.envMap=M.get(w.envMap||F.environment,Ft),F.envMapRotation=F.environment!==null&&w.envMap===null?Q.environmentRotation:w.envMapRotation,Mt===void 0&&(w.addEventListener("dispose",Xt),Mt=new Map,F.programs=Mt,F.programVariants=new Map);let Ot=Mt.get(pt);if(Ot!==void 0){if(F.currentProgram===Ot&&F.lightsStateVersion===mt)return ra(w,at),Ot}else at.uniforms=Z.getUniforms(w),O!==null&&w.isNodeMaterial&&O.build(w,H,at),w.onBeforeCompile(at,b),Ot=Z.acquireProgram(at,pt),Mt.set(pt,Ot),F.uniforms=at.uniforms;let wt=F.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(wt.clippingPlanes=W.uniform),ra(w,at),F.needsLights=cl(w),F.lightsStateVersion=mt,F.needsLights&&(wt.ambientLightColor.value=L.state.ambient,wt.lightProbe.value=L.state.probe,wt.sunLights.value=L.state.sun,wt.sunLightShadows.value=L.state.sunShadow,wt.directionalLights.value=L.state.directional,wt.directionalLightShadows.value=L.state.directionalShadow,wt.spotLights.value=L.state.spot,wt.spotLightShadows.value=L.state.spotShadow,wt.rectAreaLights.value=L.state.rectArea,wt.ltc_1.value=L.state.rectAreaLTC1,wt.ltc_2.value=L.state.rectAreaLTC2,wt.pointLights.value=L.state.point,wt.pointLightShadows.value=L.state.pointShadow,wt.hemisphereLights.value=L.state.hemi,wt.sunShadowMatrix.value=L.state.sunShadowMatrix,wt.sunShadowCascade.value=L.state.sunShadowCascade,wt.directionalShadowMatrix.value=L.state.directionalShadowMatrix,wt.spotLightMatrix.value=L.state.spotLightMatrix,wt.spotLightMap.value=L.state.spotLightMap,wt.pointShadowMatrix.value=L.state.pointShadowMatrix),F.numLightProbeGrids=ia(x.state.lightProbeGridArray),F.currentProgram=Ot,F.uniformsList=null,Ot}function rl(w,Q,H,F,L){let lt=_t.get(w),mt=lt.currentProgram.id+","+F+","+L,at=lt.programVariants.get(mt);return at===void 0?(at=FA(w,Q,H),lt.programVariants.set(mt,at)):(lt.currentProgram=at,lt.uniformsList=null,lt.outputColorSpace=F,lt.toneMapping=L),at}function sa(w){if(w.uniformsList===null){let Q=w.currentProgram.getUniforms();w.uniformsList=bA.seqWithValue(Q.seq,w.uniforms)}return w.uniformsList}function ra(w,Q){let H=_t.get(w);H.outputColorSpace=Q.outputColorSpace,H.batching=Q.batching,H.batchingColor=Q.batchingColor,H.instancing=Q.instancing,H.instancingColor=Q.instancingColor,H.instancingMorph=Q.instancingMorph,H.skinning=Q.skinning,H.morphTargets=Q.morphTargets,H.morphNormals=Q.morphNormals,H.morphColors=Q.morphColors,H.morphTargetsCount=Q.morphTargetsCount,H.numClippingPlanes=Q.numClippingPlanes,H.numIntersection=Q.numClipIntersection,H.vertexAlphas=Q.vertexAlphas,H.vertexTangents=Q.vertexTangents,H.toneMapping=Q.toneMapping}function ol(w,Q,H,F,L){Q.isScene!==!0&&(Q=Ve),Tt.resetTextureUnits();let lt=Q.fog,mt=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?Q.environment:null,at=et===null?b.outputColorSpace:et.isXRRenderTarget===!0?et.texture.colorSpace:kt.workingColorSpace,pt=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,Mt=M.get(F.envMap||mt,pt),Ft=F.vertexColors===!0&&!!H.attributes.color&&H.attributes.color.itemSize===4,Ot=!!H.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),wt=!!H.morphAttributes.position,Gt=!!H.morphAttributes.normal,oe=!!H.morphAttributes.color,jt=un;F.toneMapped&&(et===null||et.isXRRenderTarget===!0)&&(jt=b.toneMapping);let Zt=H.morphAttributes.position||H.morphAttributes.normal||H.morphAttributes.color,ve=Zt!==void 0?Zt.length:0,Ct=_t.get(F),Se=x.state.lights;if(ce===!0&&(Te===!0||w!==j)){let se=w===j&&F.id===z;W.setState(F,w,se)}let Jt=!1,Jn=!1;F.version===Ct.__version?Ct.needsLights&&Ct.lightsStateVersion!==Se.state.version||L.isBatchedMesh&&Ct.batching===!1||!L.isBatchedMesh&&Ct.batching===!0||L.isBatchedMesh&&Ct.batchingColor===!0&&L._colorsTexture===null||L.isBatchedMesh&&Ct.batchingColor===!1&&L._colorsTexture!==null||L.isInstancedMesh&&Ct.instancing===!1||!L.isInstancedMesh&&Ct.instancing===!0||L.isSkinnedMesh&&Ct.skinning===!1||!L.isSkinnedMesh&&Ct.skinning===!0||L.isInstancedMesh&&Ct.instancingColor===!0&&L.instanceColor===null||L.isInstancedMesh&&Ct.instancingColor===!1&&L.instanceColor!==null||L.isInstancedMesh&&Ct.instancingMorph===!0&&L.morphTexture===null||L.isInstancedMesh&&Ct.instancingMorph===!1&&L.morphTexture!==null||Ct.envMap!==Mt||F.fog===!0&&Ct.fog!==lt||Ct.numClippingPlanes!==void 0&&(Ct.numClippingPlanes!==W.numPlanes||Ct.numIntersection!==W.numIntersection)||Ct.vertexAlphas!==Ft||Ct.vertexTangents!==Ot||Ct.morphTargets!==wt||Ct.morphNormals!==Gt||Ct.morphColors!==oe||Ct.morphTargetsCount!==ve||Ct.numLightProbeGrids!==ia(x.state.lightProbeGridArray)?Jt=!0:(Ct.outputColorSpace!==at||Ct.toneMapping!==jt)&&(Jn=!0):(Jt=!0,Ct.__version=F.version);let De=Ct.currentProgram;(Jt===!0||Jn===!0)&&(De=Jn===!0?rl(F,Q,L,at,jt):FA(F,Q,L),O&&F.isNodeMaterial&&O.onUpdateProgram(F,De,Ct));let vi=!1,bn=!1,Wn=!1,Yt=De.getUniforms(),we=Ct.uniforms;if(ht.useProgram(De.program)&&(vi=!0,bn=!0,Wn=!0),F.id!==z&&(z=F.id,bn=!0),vi||j!==w){ht.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),Yt.setValue(T,"projectionMatrix",w.projectionMatrix),Yt.setValue(T,"viewMatrix",w.matrixWorldInverse);let ge=Yt.map.cameraPosition;ge!==void 0&&ge.setValue(T,rn.setFromMatrixPosition(w.matrixWorld)),ne.logarithmicDepthBuffer&&Yt.setValue(T,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&Yt.setValue(T,"isOrthographic",w.isOrthographicCamera===!0),j!==w&&(j=w,bn=!0,Wn=!0)}if(Ct.needsLights&&(Se.state.sunShadowMap.length>0&&Yt.setValue(T,"sunShadowMap",Se.state.sunShadowMap,Tt),Se.state.directionalShadowMap.length>0&&Yt.setValue(T,"directionalShadowMap",Se.state.directionalShadowMap,Tt),Se.state.spotShadowMap.length>0&&Yt.setValue(T,"spotShadowMap",Se.state.spotShadowMap,Tt),Se.state.pointShadowMap.length>0&&Yt.setValue(T,"pointShadowMap",Se.state.pointShadowMap,Tt)),L.isSkinnedMesh){Yt.setOptional(T,L,"bindMatrix"),Yt.setOptional(T,L,"bindMatrixInverse");let se=L.skeleton;se&&(se.boneTexture===null&&se.computeBoneTexture(),Yt.setValue(T,"boneTexture",se.boneTexture,Tt))}L.isBatchedMesh&&(Yt.setOptional(T,L,"batchingTexture"),Yt.setValue(T,"batchingTexture",L._matricesTexture,Tt),Yt.setOptional(T,L,"batchingIdTexture"),Yt.setValue(T,"batchingIdTexture",L._indirectTexture,Tt),Yt.setOptional(T,L,"batchingColorTexture"),L._colorsTexture!==null&&Yt.setValue(T,"batchingColorTexture",L._colorsTexture,Tt));let qe=H.morphAttributes;if((qe.position!==void 0||qe.normal!==void 0||qe.color!==void 0)&&X.update(L,H,De),(bn||Ct.receiveShadow!==L.receiveShadow)&&(Ct.receiveShadow=L.receiveShadow,Yt.setValue(T,"receiveShadow",L.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&Q.environment!==null&&(we.envMapIntensity.value=Q.environmentIntensity),we.dfgLUT!==void 0&&(we.dfgLUT.value=Pg()),bn){if(Yt.setValue(T,"toneMappingExposure",b.toneMappingExposure),Ct.needsLights&&al(we,Wn),lt&&F.fog===!0&&it.refreshFogUniforms(we,lt),it.refreshMaterialUniforms(we,F,gt,xt,x.state.transmissionRenderTarget[w.id]),Ct.needsLights&&Ct.numLightProbeGrids>0){let se=D,ge=0;for(let gn of x.state.lightProbeGridArray)gn.texture!==null&&(se.textures[ge]=gn.texture,se.min[ge]=gn.boundingBox.min,se.max[ge]=gn.boundingBox.max,se.resolution[ge]=gn.resolution,ge++);for(let gn in se)se[gn].length=ge;we.probesSH.value=se.textures,we.probesMin.value=se.min,we.probesMax.value=se.max,we.probesResolution.value=se.resolution}bA.upload(T,sa(Ct),we,Tt)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(bA.upload(T,sa(Ct),we,Tt),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&Yt.setValue(T,"center",L.center),Yt.setValue(T,"modelViewMatrix",L.modelViewMatrix),Yt.setValue(T,"normalMatrix",L.normalMatrix),Yt.setValue(T,"modelMatrix",L.matrixWorld),F.uniformsGroups!==void 0){let se=F.uniformsGroups;for(let ge=0,gn=se.length;ge<gn;ge++){let aa=se[ge];vt.update(aa,De),vt.bind(aa,De)}}return De}function al(w,Q){w.ambientLightColor.needsUpdate=Q,w.lightProbe.needsUpdate=Q,w.sunLights.needsUpdate=Q,w.sunLightShadows.needsUpdate=Q,w.directionalLights.needsUpdate=Q,w.directionalLightShadows.needsUpdate=Q,w.pointLights.needsUpdate=Q,w.pointLightShadows.needsUpdate=Q,w.spotLights.needsUpdate=Q,w.spotLightShadows.needsUpdate=Q,w.rectAreaLights.needsUpdate=Q,w.hemisphereLights.needsUpdate=Q}function cl(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return et},this.setRenderTargetTextures=function(w,Q,H){let F=_t.get(w);F.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),_t.get(w.texture).__webglTexture=Q,_t.get(w.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:H,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,Q){let H=_t.get(w);H.__webglFramebuffer=Q,H.__useDefaultFramebuffer=Q===void 0},this.setRenderTarget=function(w,Q=0,H=0){et=w,q=Q,G=H;let F=null,L=!1,lt=!1;if(w){let at=_t.get(w);if(at.__useDefaultFramebuffer!==void 0){ht.bindFramebuffer(T.FRAMEBUFFER,at.__webglFramebuffer),$.copy(w.viewport),Et.copy(w.scissor),Pt=w.scissorTest,ht.viewport($),ht.scissor(Et),ht.setScissorTest(Pt),z=-1;return}else if(at.__webglFramebuffer===void 0)Tt.setupRenderTarget(w);else if(at.__hasExternalTextures)Tt.rebindTextures(w,_t.get(w.texture).__webglTexture,_t.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Ft=w.depthTexture;if(at.__boundDepthTexture!==Ft){if(Ft!==null&&_t.has(Ft)&&(w.width!==Ft.image.width||w.height!==Ft.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Tt.setupDepthRenderbuffer(w)}}let pt=w.texture;(pt.isData3DTexture||pt.isDataArrayTexture||pt.isCompressedArrayTexture)&&(lt=!0);let Mt=_t.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Mt[Q])?F=Mt[Q][H]:F=Mt[Q],L=!0):w.samples>0&&Tt.useMultisampledRTT(w)===!1?F=_t.get(w).__webglMultisampledFramebuffer:Array.isArray(Mt)?F=Mt[H]:F=Mt,$.copy(w.viewport),Et.copy(w.scissor),Pt=w.scissorTest}else $.copy(St).multiplyScalar(gt).floor(),Et.copy(Kt).multiplyScalar(gt).floor(),Pt=qt;if(H!==0&&(F=J),ht.bindFramebuffer(T.FRAMEBUFFER,F)&&ht.drawBuffers(w,F),ht.viewport($),ht.scissor(Et),ht.setScissorTest(Pt),L){let at=_t.get(w.texture);T.framebufferTexture2D(T.FRAMEBUFFER,T.COLOR_ATTACHMENT0,T.TEXTURE_CUBE_MAP_POSITIVE_X+Q,at.__webglTexture,H)}else if(lt){let at=Q;for(let pt=0;pt<w.textures.length;pt++){let Mt=_t.get(w.textures[pt]);T.framebufferTextureLayer(T.FRAMEBUFFER,T.COLOR_ATTACHMENT0+pt,Mt.__webglTexture,H,at)}}else if(w!==null&&H!==0){let at=_t.get(w.texture);T.framebufferTexture2D(T.FRAMEBUFFER,T.COLOR_ATTACHMENT0,T.TEXTURE_2D,at.__webglTexture,H)}z=-1};function oa(w){let Q=_t.get(w);return(Q.__readFormat!==w.format||Q.__readType!==w.type)&&(Q.__readFormat=w.format,Q.__readType=w.type,Q.__formatReadable=ne.textureFormatReadable(w.format),Q.__typeReadable=ne.textureTypeReadable(w.type)),Q}this.readRenderTargetPixels=function(w,Q,H,F,L,lt,mt,at=0){if(!(w&&w.isWebGLRenderTarget)){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let pt=_t.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&mt!==void 0&&(pt=pt[mt],Array.isArray(pt)&&(pt=pt[0])),pt){ht.bindFramebuffer(T.FRAMEBUFFER,pt);try{let Mt=w.textures[at],Ft=Mt.format,Ot=Mt.type;w.textures.length>1&&T.readBuffer(T.COLOR_ATTACHMENT0+at);let wt=oa(Mt);if(wt.__formatReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(wt.__typeReadable===!1){Qt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}Q>=0&&Q<=w.width-F&&H>=0&&H<=w.height-L&&T.readPixels(Q,H,F,L,At.convert(Ft),At.convert(Ot),lt)}finally{let Mt=et!==null?_t.get(et).__webglFramebuffer:null;ht.bindFramebuffer(T.FRAMEBUFFER,Mt)}}},this.readRenderTargetPixelsAsync=async function(w,Q,H,F,L,lt,mt,at=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let pt=_t.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&mt!==void 0&&(pt=pt[mt],Array.isArray(pt)&&(pt=pt[0])),pt)if(Q>=0&&Q<=w.width-F&&H>=0&&H<=w.height-L){ht.bindFramebuffer(T.FRAMEBUFFER,pt);let Mt=w.textures[at],Ft=Mt.format,Ot=Mt.type;w.textures.length>1&&T.readBuffer(T.COLOR_ATTACHMENT0+at);let wt=oa(Mt);if(wt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(wt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Gt=T.createBuffer();T.bindBuffer(T.PIXEL_PACK_BUFFER,Gt),T.bufferData(T.PIXEL_PACK_BUFFER,lt.byteLength,T.STREAM_READ),T.readPixels(Q,H,F,L,At.convert(Ft),At.convert(Ot),0),T.bindBuffer(T.PIXEL_PACK_BUFFER,null);let oe=et!==null?_t.get(et).__webglFramebuffer:null;ht.bindFramebuffer(T.FRAMEBUFFER,oe);let jt=T.fenceSync(T.SYNC_GPU_COMMANDS_COMPLETE,0);return T.flush(),await mc(T,jt,4),T.bindBuffer(T.PIXEL_PACK_BUFFER,Gt),T.getBufferSubData(T.PIXEL_PACK_BUFFER,0,lt),T.bindBuffer(T.PIXEL_PACK_BUFFER,null),T.deleteBuffer(Gt),T.deleteSync(jt),lt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,Q=null,H=0){let F=Math.pow(2,-H),L=Math.floor(w.image.width*F),lt=Math.floor(w.image.height*F),mt=Q!==null?Q.x:0,at=Q!==null?Q.y:0;Tt.setTexture2D(w,0),T.copyTexSubImage2D(T.TEXTURE_2D,H,0,0,mt,at,L,lt),ht.unbindTexture()},this.copyTextureToTexture=function(w,Q,H=null,F=null,L=0,lt=0){let mt,at,pt,Mt,Ft,Ot,wt,Gt,oe,jt=w.isCompressedTexture?w.mipmaps[lt]:w.image;if(H!==null)mt=H.max.x-H.min.x,at=H.max.y-H.min.y,pt=H.isBox3?H.max.z-H.min.z:1,Mt=H.min.x,Ft=H.min.y,Ot=H.isBox3?H.min.z:0;else{let Yt=Math.pow(2,-L);mt=Math.floor(jt.width*Yt),at=Math.floor(jt.height*Yt),w.isDataArrayTexture?pt=jt.depth:w.isData3DTexture?pt=Math.floor(jt.depth*Yt):pt=1,Mt=0,Ft=0,Ot=0}F!==null?(wt=F.x,Gt=F.y,oe=F.z):(wt=0,Gt=0,oe=0);let Zt=At.convert(Q.format),ve=At.convert(Q.type),Ct;Q.isData3DTexture?(Tt.setTexture3D(Q,0),Ct=T.TEXTURE_3D):Q.isDataArrayTexture||Q.isCompressedArrayTexture?(Tt.setTexture2DArray(Q,0),Ct=T.TEXTURE_2D_ARRAY):(Tt.setTexture2D(Q,0),Ct=T.TEXTURE_2D),ht.activeTexture(T.TEXTURE0),ht.pixelStorei(T.UNPACK_FLIP_Y_WEBGL,Q.flipY),ht.pixelStorei(T.UNPACK_PREMULTIPLY_ALPHA_WEBGL,Q.premultiplyAlpha),ht.pixelStorei(T.UNPACK_ALIGNMENT,Q.unpackAlignment);let Se=ht.getParameter(T.UNPACK_ROW_LENGTH),Jt=ht.getParameter(T.UNPACK_IMAGE_HEIGHT),Jn=ht.getParameter(T.UNPACK_SKIP_PIXELS),De=ht.getParameter(T.UNPACK_SKIP_ROWS),vi=ht.getParameter(T.UNPACK_SKIP_IMAGES);ht.pixelStorei(T.UNPACK_ROW_LENGTH,jt.width),ht.pixelStorei(T.UNPACK_IMAGE_HEIGHT,jt.height),ht.pixelStorei(T.UNPACK_SKIP_PIXELS,Mt),ht.pixelStorei(T.UNPACK_SKIP_ROWS,Ft),ht.pixelStorei(T.UNPACK_SKIP_IMAGES,Ot);let bn=w.isDataArrayTexture||w.isData3DTexture,Wn=Q.isDataArrayTexture||Q.isData3DTexture;if(w.isDepthTexture){let Yt=_t.get(w),we=_t.get(Q),qe=_t.get(Yt.__renderTarget),se=_t.get(we.__renderTarget);ht.bindFramebuffer(T.READ_FRAMEBUFFER,qe.__webglFramebuffer),ht.bindFramebuffer(T.DRAW_FRAMEBUFFER,se.__webglFramebuffer);for(let ge=0;ge<pt;ge++)bn&&(T.framebufferTextureLayer(T.READ_FRAMEBUFFER,T.COLOR_ATTACHMENT0,_t.get(w).__webglTexture,L,Ot+ge),T.framebufferTextureLayer(T.DRAW_FRAMEBUFFER,T.COLOR_ATTACHMENT0,_t.get(Q).__webglTexture,lt,oe+ge)),T.blitFramebuffer(Mt,Ft,Mt+mt,Ft+at,wt,Gt,wt+mt,Gt+at,T.DEPTH_BUFFER_BIT,T.NEAREST);ht.bindFramebuffer(T.READ_FRAMEBUFFER,null),ht.bindFramebuffer(T.DRAW_FRAMEBUFFER,null)}else if(L!==0||w.isRenderTargetTexture||_t.has(w)){let Yt=_t.get(w),we=_t.get(Q);ht.bindFramebuffer(T.READ_FRAMEBUFFER,I),ht.bindFramebuffer(T.DRAW_FRAMEBUFFER,V);for(let qe=0;qe<pt;qe++)bn?T.framebufferTextureLayer(T.READ_FRAMEBUFFER,T.COLOR_ATTACHMENT0,Yt.__webglTexture,L,Ot+qe):T.framebufferTexture2D(T.READ_FRAMEBUFFER,T.COLOR_ATTACHMENT0,T.TEXTURE_2D,Yt.__webglTexture,L),Wn?T.framebufferTextureLayer(T.DRAW_FRAMEBUFFER,T.COLOR_ATTACHMENT0,we.__webglTexture,lt,oe+qe):T.framebufferTexture2D(T.DRAW_FRAMEBUFFER,T.COLOR_ATTACHMENT0,T.TEXTURE_2D,we.__webglTexture,lt),L!==0?T.blitFramebuffer(Mt,Ft,Mt+mt,Ft+at,wt,Gt,wt+mt,Gt+at,T.COLOR_BUFFER_BIT,T.NEAREST):Wn?T.copyTexSubImage3D(Ct,lt,wt,Gt,oe+qe,Mt,Ft,mt,at):T.copyTexSubImage2D(Ct,lt,wt,Gt,Mt,Ft,mt,at);ht.bindFramebuffer(T.READ_FRAMEBUFFER,null),ht.bindFramebuffer(T.DRAW_FRAMEBUFFER,null)}else Wn?w.isDataTexture||w.isData3DTexture?T.texSubImage3D(Ct,lt,wt,Gt,oe,mt,at,pt,Zt,ve,jt.data):Q.isCompressedArrayTexture?T.compressedTexSubImage3D(Ct,lt,wt,Gt,oe,mt,at,pt,Zt,jt.data):T.texSubImage3D(Ct,lt,wt,Gt,oe,mt,at,pt,Zt,ve,jt):w.isDataTexture?T.texSubImage2D(T.TEXTURE_2D,lt,wt,Gt,mt,at,Zt,ve,jt.data):w.isCompressedTexture?T.compressedTexSubImage2D(T.TEXTURE_2D,lt,wt,Gt,jt.width,jt.height,Zt,jt.data):T.texSubImage2D(T.TEXTURE_2D,lt,wt,Gt,mt,at,Zt,ve,jt);ht.pixelStorei(T.UNPACK_ROW_LENGTH,Se),ht.pixelStorei(T.UNPACK_IMAGE_HEIGHT,Jt),ht.pixelStorei(T.UNPACK_SKIP_PIXELS,Jn),ht.pixelStorei(T.UNPACK_SKIP_ROWS,De),ht.pixelStorei(T.UNPACK_SKIP_IMAGES,vi),lt===0&&Q.generateMipmaps===!0&&Q.mipmapsAutoUpdate===!0&&T.generateMipmap(Ct),ht.unbindTexture()},this.initRenderTarget=function(w){_t.get(w).__webglFramebuffer===void 0&&Tt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Tt.setTextureCube(w,0):w.isData3DTexture?Tt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Tt.setTexture2DArray(w,0):Tt.setTexture2D(w,0),ht.unbindTexture()},this.resetState=function(){q=0,G=0,et=null,ht.reset(),st.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Xe}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=kt._getDrawingBufferColorSpace(t),e.unpackColorSpace=kt._getUnpackColorSpace()}};var PA={links:{fr3_link0:"link0",fr3_link1:"link1",fr3_link2:"link2",fr3_link3:"link3",fr3_link4:"link4",fr3_link5:"link5",fr3_link6:"link6",fr3_link7:"link7",fr3_hand:"hand",fr3_leftfinger:"finger",fr3_rightfinger:"finger"},meshes:{finger:[{rgb:[.902,.922,.929],positions:"DABeAOIBAACAAMIBIgBeAMoB9/9eAOQB3f9eAMcBmP+4ACgAZwDFACgAmf/FACgAaAC2ACgAmf+uAD8AaQCsAC8AmP+uADAAZwCuAD8Amf8aABIAl/9RABEAmP8ZAAEAmf9QACYAl/9rACYAmP+AAL0Amv+uALEAmP90ALIAmP9yADAAmf+iALwAl//QABEAmf/QACcAmP8HAQIAmf8HARIAZgBnACgARABPACcAZwBQACYAvf9OACcAzv88ACcAz/8aACcAMQA/ACgAMQAZACYAaAAaABIAMQAZABIAaAAZAAIAz/8ZABIAaAAHAQEAMQAHARIAaAAHARIA0P8HASYAMAAHAScAz/8HARIA0f/nACgALwDnACgAaAB0ALEAaAByADAAZwChAL0AaAB+ALwAZwDQACcAaQDQABEAaQBRABEAaQCqALEARwDSABMANADhABMARgDSACUANAA9ABMARgBOABMAuf/SABMAzP/hABMAuv/SACUAzf84ABMAuP9OABMAxv9GABMAmf/oACgApf+bAGUBWwCbAGUBmP/8AMAAaAD9AL4AWwCNAGUBpf+NAGUBy/+PABoCqf+QAPIBsv+OAAsCMACPABoCUgCNAAcCQQCPABQCNwBeABgCyf9fABkCrP9hAAMCqf9eAGgB7P9eAKYBTQBfAAoCWABfAPYBAQBeAJ8BIABeALYBVwBeAGgBEwBeAKYBWgBRAGYBpv9QAGUBl/+xAMEAWgBQAGQBaQCxAMEAmP/9AD0AaAD9AD0AZwDoACgAWgCNAPEBnv+vAG8Apv+vAF8Anv/MAHQArP/MAFoAzP/MAJ0Ax/+uAKEAuv/MAJwArv+uAJsAtv+uAFIAp//MAJEAxP/MAFIAn/+xAH8A6v+xAHYA7f+uAIEA5P+xAIsA2v+xAJYA1v+xAFYA4v+xAGEA4f/MAJEA3P/MAFoA6v/MAHQAFgDMAHQAGQCvAGcAJADMAFoAQgCxAJ4ALACxAJsARADMAJ0AKgCuAFMAHwDMAJEAQgCuAFAAPADMAFIAHACuAJIAFgCwAH0AVACwAJcAOwCuAKIAVQCuAFcAXACxAIsAZACuAG0AWQDMAJEAVADMAFoAYgDMAHQA",indices:"AAABAAIAAAADAAEABAABAAMABQAGAAcABQAIAAYACQAKAAsACQAMAAoADQAOAA8AEAARAA4AEgATABQAFAATABUAFQATAAsAEgAWABMACwAFABEAFQALABEAEQAXAA4ABQAXABEABQAYABcAFwAZAA4ADgAZAA8AFwAaABkAGwAcAB0AGwARABwAHAARAB4AEQAQAB4AHwAgACEAIQAgACIAHAAeACEAHgAfACEAIwAkACUAIgAmACQAIAAmACIADQAPACYADwAlACQADwAkACYAJwAoACkAKAAqACsALAAqACgAGQAaACwAJwAZACgAKAAZACwALQArACoALQAuACsADwAnACUADwAZACcALwAUADAAFAAVADAAFgASADEAMQASADIAMwAIADQAJwA0ADUAJwA1ACUANQAjACUAKQA0ACcAGwAdADUANgAwAAoANgAvADAANgAyAC8AMQAyADYACgAwABsACAAKABsANAAbADUANAAIABsAKQA3ADQAOAA3ACkAKAA4ACkAOAA5ADcALgA5ADgAKwAuACgAKAAuADgAOQA0ADcAOQAzADQAOgAkACMAOwAjADUAOwA6ACMAOwAcADoAHAAhADoAHQA7ADUAHQAcADsAIQAiADoAOgAiACQAGgAXADwAGgA9ACwAGgA8AD0APAA+AD0APgAtAD0AGAA+ADwAGAA8ABcALQAqACwALQAsAD0ADQAmAD8AQAA/AEEAQAANAD8ADgANAEAAPwAfAEEAHwAeAEEAQQAeAEAAIAAfAD8AIAA/ACYAQAAQAA4AHgAQAEAAMAAVABsAFQARABsABQALAAgACAALAAoANgATABYAMQA2ABYAMgASABQALwAyABQABwAYAAUACQALABMACAAzAAYANgAKAAwAPgBCAC0APgAYAEIAQwBEAEUARABGAEUAQwBHAEQASABHAEMASQBKAEsATABKAEkATQBKAEwARwBIAE0ATQBIAEoATQBMAE4ASQBPAEwAUABPAEkAUQADAFAAUQAEAAMAUAADAE8AUQBSAAQAUgBTAAQAAwAAAE8ATwAAAFQAAABVAFQAUgBWAFMAAgBVAAAAVwBYAAIAWQBYAFcAAgBYAFUAVgBYAFkAUgBYAFYAUgBaAFgAWwBaAFIAXABdAFsAXgBdAFwAEwA2AFwANgBeAFwADABeADYAXAAJABMARQBGAF8ARgBgAF8AMwA5AGEAYQA5AC4ADABgAEYADABGAF4ABgBhAGAABgBgAAwAXwAJAEUARQAJAFwAQgAHAF8AXwAHAAkAXABDAEUAXABbAEMASABbAFIASABDAFsAUgBRAEoAUgBKAEgAYgBYAEcAVQBYAGIAXQBYAFoARABHAF0AXQBHAFgARABeAEYAXQBeAEQABgAJAAcADAAJAAYAYQAuAGAALQBfAC4ALgBfAGAALQBCAF8AUABJAEsAUQBQAEsAUQBLAEoAVQBiAE0AVABVAE0AVABNAE4ATwBUAE4ATwBOAEwABgAzAGEABwBCABgARwBNAGIAAgABAFcAWQBXAAEAUwABAAQAUwBWAAEAVgBZAAEAWgBbAF0AYwBkAGUAZQBkAGYAZwBoAGkAaABqAGkAZABrAGYAaQBqAGwAZgBrAG0AagBuAGwAbABuAGUAbgBjAGUAbwBwAHEAcAByAHEAawByAHMAcwByAHQAaAByAGsAdAByAHAAbgBqAGMAagBoAGMAYwBoAGQAZABoAGsAdABwAG8AbwBxAHUAcQByAHUAbQBzAHYAawBzAG0AdQByAGcAcgBoAGcAcwB0AHYAdgB0AHcAdABvAHcAdwBvAHUAdQBnAGkAdQBpAGwAdQBsAGUAdgB1AGUAdgBlAGYAdgB3AHUAdgBmAG0AeAB5AHoAewB8AH0AeQB+AHoAfQB8AH8AegCAAIEAfgCAAHoAfACCAH8AggCDAH8AfwCDAHgAgwB5AHgAhACFAHsAewCFAHwAhQCCAHwAhgCHAIgAhQCHAIYAhQCEAIcAeQCCAH4AfgCCAIAAgACFAIYAggCFAIAAgwCCAHkAiACHAIkAhwCEAIkAgQCGAIoAgACGAIEAiQCEAH0AhAB7AH0AigCGAIsAhgCIAIsAiwCIAIkAegB/AHgAigCJAH0AigCLAIkAigB9AIEAgQB9AH8AgQB/AHoA",count:272},{rgb:[.251,.251,.251],positions:"9/8TALQB7v9eALcB8f8TAMsB8/9eAM4BAgBeANQBCQATANAB+f9eAK4B6/9eAMUB6v9tAMYB8f9eANIB9f9tANYBBwBeAK4B+f9tAK0B7P9tALkB4/9eALgB4v9eAMkB4v9tAMUB5/9tALEB7v9eANwBBABtAOAB7f9tANoBBQBeAOAB7v9eAKkB9v9tAKYBAABeAKMBCgBtAKUBFwD//9kBMAAAABkCFwAAABkCRwAAABACVwAAAPcBWAAAANkBWAAAAGsBWAAAAKsBFgD//6wBFwAAAGoB6f///9kB6f8AABkCx/8AABgCsv8AAAcCqf8AAPMBqP8AANkB6f8AAGoB6v///6wBqP8AAKsBqP8AAGsBWAAQAMIBWABdAPoBWQBdAGkBqP8QAMIBp/9dAPMBp/9dAGkBAAAQABoCAAAPAMIBAAAQAGoBLwBeABsCy/9eABoC5f9eAKMB2f9eALsBSwBeALsBSwBeAMoBFgBeAOQBGQBeANQBt/9eAPsBsf9eAAoCSwBeAHcBCABeAHcBzv9eAAwC+P9eAHcBtf9eAHcBtf9eALoBIgBeANcBRQBeABMCSgBeAPcBNQBeAAwCtf9eAMkB+P9eAA0CJwBeAMkB+f9eAJsBHgBeAL8BBwBeAA0CJwBeALsBBwBeAJsBFQBeAKsBIgBeAKwB+f9eAOkB2f9eAMkB6/9eAOQB3v9eANgBBwBeAOkBSQAOAHkBSQAOALkBKQAOALgBGwAOAKEBCQAOAJkBCQAOAHkBt/8OAHkB9/8OAHkB9/8OAJkB4v8OAKQB1/8OALkBt/8OALkBuf8OAPgBzf8OAAoCt/8OAMsB1/8OAMwB9/8OAOsB5f8OAOMB9/8OAAsCQgAOAAACSQAOAPABMQAOAAsCCQAOAAsCCgAOAOsBKQAOAMsBIQAOAN0BSQAOAMsBCgBtAK8BFABtALkBFwBtALABHgBtAL4BCABtANYBFQBtAMoBFwBtANYBFgBeAL4BDgBeANIBEQBeAMgBDwATALkBDQBeALYB",indices:"AAABAAIAAQADAAIAAwAEAAIAAgAEAAUABgABAAAABwAIAAkACAAKAAkACwAMAAYACQAKAAQABgAMAAEADAANAAEAAQANAAcADQAIAAcADgAPABAADgAQABEAEgATABQAEgAVABMAFgAOABEAFgARABcAGAAWABcAGAAXABkADwASABQADwAUABAAGgAbABwAGgAdABsAHgAdABoAHwAeABoAIAAhACIAIAAiACMAJAAlACYAJAAmACcAJAAnACgAJAAoACkAKgArACwAKgAsAC0ALgAeAB8ALgAvAB4AMAAvAC4AIQAwAC4AIAAwACEAMQApACgAMgAxACgAMwAsADEAMwAtACwAMwAxADIAGgAcADQANQAaADQANgAjACIANgAiADUAJAA1ADQAJAA0ACUANgA1ACsAKgA2ACsAMwAqAC0ANgAqADMAMAAjADYAMAAgACMAMAA2ADMANAA3ADgANAA4ACYANAAmACUAGwA0ABwAGwA3ADQADgA5ADoADgAWADkALwA7ADwAPQA+ABUAOAA/AEAAQQAwAEIAOABDAD8AOwAwAEEALwAwADsAMAAzAEIAQgAzAEQARQAzAEYARgAzADIAQAA/ADIAPQBHAD4ASABJAEoAPwBLADIAOABMAEMASAAvAEkAGAA5ABYARwBNAD4AGABOADkAPgBNAE8AOABQAEwASwBGADIATQBRAE8AGABSAE4AUwBSABgAUQBUAE8AOAA3AFAAUABVAEwASwBWAEYATwBUAFMAVwASAFgAUwBUAFIARQBEADMATQA8AFEAEgAPAFgALwA8AEkAVQASAFcAWAAPAFYANwBKAFAAVQAVABIAUgBCAE4AUABZAFUATgBCAEQAVgA6AEYAVgAPADoAWQAVAFUAPAA7AFEADwAOADoASABKADcAPQAVAFkALwBIAB0ALwAdAB4ASAAbAB0ASAA3ABsAQAAnACYAOABAACYAMgAoACcAQAAyACcAOwBaAFsAQQBaADsAUQBbAFwAOwBbAFEAXQBeAFIAXQBSAFQAXABdAFQAXABUAFEAXwBSAF4AXwBCAFIAWgBBAF8AXwBBAEIAXQBfAF4AWgBfAF0AWwBdAFwAWwBaAF0AYABEAEUAYQBEAGAATgBhAGIARABhAE4AYwA6ADkAYwBkADoAYgA5AE4AYgBjADkAOgBlAEYAOgBkAGUAYABGAGUAYABFAEYAYwBhAGAAYwBgAGUAYgBhAGMAZABjAGUAZgA/AGcAPwBDAGcAaAA/AGYAaABLAD8AaABWAEsAaQBWAGgAagBVAFcAawBqAFcAawBXAFgAaQBrAFgAaQBYAFYAVQBsAEwAVQBqAGwAQwBsAGcATABsAEMAaQBoAGYAawBpAGYAZwBrAGYAZwBqAGsAbABqAGcAbQBJAG4AbwBKAG0ASgBJAG0ASgBwAFAASgBvAHAAcABZAFAAcQBZAHAAcgBNAEcAcwByAEcAcwBHAD0AcQBzAD0AcQA9AFkAdABNAHIAdAA8AE0ASQB0AG4APAB0AEkAbwBzAHEAbwBxAHAAbgByAHMAbgB0AHIAbQBuAHMAbQBzAG8ADAARAA0ADQARABAADAAXABEACAANABAADAAZABcAdQAZAAwACAAQABQAdgAZAHUAdwAZAHYACgAIABQAeAB3AHYAEwB5AAoAEwAKABQAeAB2AHoAewB4AHoAEwB6AHkAewB6ABMAPgBPAHgAPgB4AHsAUwAYABkAFQA+AHsAUwAZAHcAFQB7ABMAUwB3AHgATwBTAHgAfAB2AAsACgB5AAQAdgB1AAsABAB5AH0AdQAMAAsAeQB6AH0AfQB6AHwAegB2AHwABQB+AH8AfgCAAH8AgAAGAH8AfwAGAAAABAB+AAUAgAB8AAsABAADAAkAfQB+AAQAAwABAAkACQABAAcAfQB8AH4AfgB8AIAAgAALAAYABQB/AAAABQAAAAIAKwA1ADEAKwAxACwAJAApADEANQAkADEALgAfABoALgAaADUALgA1ACIAIQAuACIA",count:254}],hand:[{rgb:[1,1,1],positions:"fQCf/sb/lACi/sv/jADb/sb/KAA9/nX/IQA9/m//KAA+/qv/AAAw/H3/CwAa/Kf/CAAX/Lz/EwAJ/LL/EAAt/HP/FgAc/HP/BgA3/HH/FgAO/Hz/FgD4+9D/FwAB/F0AmAAVAV0AmQDn/mUAmQBo/W8AmgDF/k4AmQA0AWsAmQCXAm8AaABj/ZMChwBs/JMCcwBu/ZICfgCYA5MCbwCbApMCdAC6/qn/LACl/Lr/8wBjAbD/pQAyAa//CwBFAbH/0QD0Aq7/jwAU/AgCjgAX/C8C3v8T/EICAAA0/MQAjgAn/CABef8r/P8AKAA3/KIAkwBF/H4AFgA6/KwAtQBG/PcBrQAp/PkBrwBn/HEAqQC6/N3/sQCy/Pr/pgCE/AIAqgAw/CwCsQBw/GMCjgBW/IQCngBl/IQCtwC4/EQCqwCs/HwCdwAb/EUCPgAl/GECrwC6AgYBsgAA/REBsQBU/QwBvwCbAygCuAB9A1UCrwCxAnwAtgAoAysBrwDQAt0ArwBB/QMBsADPAvAAzgC2A8oBvQDjAngA8QBuA5sArAAg/cn/tgD4/vD/swD2/k4AsQBd/W8AtwBW/WIAyQA5AT8AtAANAVMAvQAcATUAxwC7AkgAsQAkAWwAyABVAUkAsAAu/eIAsABE/YwA+ABDA1EAuAChAlsAtgAHAQkA9gBHARAAxwArAR8AHgFzAQYArwCdAm8AIAGhAQYADAFOAQAADAHYAgcAzwA3AdD/BAH1AhIAvgAnAc7/EwFfAcn/+QBIAc//rQAOAcH/GwF9Acj/+ABLA+T/7gCMAzYAewCrA4kCjACdA44CkQDDA2oCCQHGAsn/tQDLAyYCsADbAxoCTgDtAz4CHADEA38CrACEA3sCowDBA1wCS/9wA+L/zgCMAwYA2ABNA83/tADZAxcB0QCzA2gAuQC2A1sAkABd/CUAkgD3/LL/LAA9/FMAKwBw/O3/iwDV/Lb/KAAb/Hr/KAAa/IMAqQAQAU8AogDs/lMApQDs/r3/awDS/rz/KADD/r3/pgAaAbb/uAAuAbz/EgHwAbf//gBTAb//CwFmAbn/1QA+AcP/mAAhAbL/1ABHAbj/9gALA7//6gDZArD/5wCJAxcA3QCsA2oAwQCjAy0A1QChAzIA3gBoA+T/7gBKA9T/1AAlA7n/vADcA8UBzgDJAwsBqQDmAwcCpwDoA7gBkADsAyYCoQBmA4sCnAB6/IsC+/9O/IsCKgBa/JECngAl/bb/lQDX/rD/owDj/MH/kgB//O7/mQCv/Mr/nQBn/CAAogBV/GQAoQCj/Nv/oAAw/BoBjQAZ/JQBogAd/PsBOgAW/EYCowAi/BsCAAAY/DYACQAY/EkAAAAc/E4ADQAl/HEACgBB/I8AAAA0/H4AAABC/I0AFQAO/GcAFQAi/JUAAAAY/L3/TgA2Abv/CgDA/r//mQBR/X0AmQA0/fIAmQBF/QIBmQC5AgQBmQDMAu0AmQCvAn4AgACY/joAJAAk/HL/IQAR/Hj/JAAA/J//JwAA/MD/HQD0+wcAJAAB/FkAIwAb/JAAGgAW/IoAFgAB/Jr/EgA//JcAe/+i/sX/gP+Y/joAgP+Y/sb/nv/N/sL/2P89/nX/3/89/m//2P89/qz/8v8Y/KT/9f8V/MD/7f8M/Ln/6v8c/HP/9P8w/HX/7P/++0EA7P8E/Jj/6P8J/HMA7f81/L8A8f83/L0AZv8ZAWEAZ/9o/W8AZ//n/mUAZv/n/tf/Zv/F/k4AZ/+i/t7/Z/80AWsAZ/+XAm8Alv9l/ZICb/9w/JACjf9u/ZICcv+RA5ECkP+ZApICpP+5/qz/1f9F/aT/fP86Aaz/CP9xAa//Fv/ZArD/+f5oAbb/cP8W/CECaf8b/KsB2P83/KIA5f85/KwAbv9A/JgAYv8g/CcCW/9B/E4CUv8z/B4CXf9v/IICSv95/EgCVf9R/KAAS/9E/N4BSv+h/HcAV/91/CsATv+h/GsCWP+Y/PL/Sv/1/CEAmP8e/E0Cj/9X/IwCe/9j/I8Cd/8m/EoCT//r/OX/WP8k/OgBZP9g/IECUf+6AgYBT/9U/QwBTv8A/REBSf83A0QCPf+hAwwCRv82Ay8BUv+tAngAUP/RAuEAT/80/f0AUP/MAvYAFP9tA7cASf+4/EQCRv/SAm8ASv/4/vD/VP8g/cn/Av8kAzEAPP++Ak4ACf9HA1kATf/2/k4AUf9c/XIATP8IAU4AQf87AU8ARv8YAUIALf9SAT4AOf8xATwAHf9HASoAMf8zAR8A9/5SAQoA5f5vAQoATP88AWMAUf+dAm8AT/8w/b0AT/9W/XIA+f7eAgoAT//aAGsASv8HAd7/Sf8SAeH/Pv8lASoAM/+bAkEAJv86Ac//Rf8iAdL/4v6DAdT/6f5kAdL/9f5TAdP/Iv+xA9gAFv+WA04AA/80A+L/Uv98A3gCX/+pA3gCVf+XA3ECnP/kA0oCfv+tA4cCdf/mAzcC7f4/Asj//f7pAsb/W//gAycCQ//MAwQCHv8FA7T/H/83A8T/Lf+bAyIAH/9bA9r/Hv+EAwcANv+tA0wANf+5A3YAP//IA74AT//hA4ABWv/nAw0CiP/sAzQCd/95/PL/dv+i/Mv/2P+P/Nf/dv9Y/DIAdf/V/Lb/2P/D/Ln/2P9p/AcAcf8O/a//2f8C/EoA2P8N/In/2P8m/Hb/2P8S/HQAV/8QAb3/Y/8XAVkAaP8aARUAW//s/r3/Xv/s/lMA2v/C/rr/lf/S/rz/8P5fAcb/9v6PAbT/5v5+AcX/RP9GAbH/DP9QAbz/X/8jAbH/Rf81Abn/CP/VArf/Iv+hA0EAI/+uA3cADv8tA8n/FP9fA+b/EP9zAwgAOf/SA1MBRf/bA9MBzP/rA0QCZP+PA4sCiP+gA5ACWv+O/IQCYv8l/bb/a//X/rD/Xv/t/L7/Wv/L/M3/a//q/LX/YP9V/FwAZf+3/Mn/X/+R/On/aP95/Pv/af8s/BgBWv80/CQB7/8Y/F8A7P86/KgA8P8w/IcA+P8y/H8A9/8Y/EkA7v8//JcAzP88Abv/kv8tAbz/AABAAbr/Uv9N/X8AZ/9R/X0AZ/8w/eMAUv8w/d0AZ/80/fIAUv8y/e8AZ/9O/QcBUf9B/QMBZ/88/f0AZ/+5AgQBZ//MAu0AZ/+2AoYAZ/+pAncA5P8n/G//3P8Q/H3/3v8b/HP/3P8B/J3/2//6++T/6P8G/Ij/5//1+wkA5P/8+00A4P8k/JwA6v/4+83/9v9B/I8AkP+YAkgCcgBr/UgCcgCTAkgCZwCeAkkCYQBi/UkCkP9o/UgClP+s/goApv+p/goAbACs/goA4/8+AQoAlwAaARQADgBAAQoAVAA1AQoAbf8cAQoAhP8nAQoAhgAiAQoA5P+o/goA",indices:"AAABAAIAAwAEAAUABgAHAAgACQAKAAsACQAHAAoABwAGAAwACQALAA0ACAAHAAkADAAKAAcACQAOAA8AEAARABIAAgABABMAFAAQABIAFAASABUAFgAXABgAFwAZABgAGAAZABoAGwAcAAUAHQAeAB8AHQAfACAAIQAiACMAJAAlACYAJwAoACkAJAApACUAKQAoACUAKgArACwALQAuAC8AKwAqADAAMAAqADEAMgAwADMAMAAxADMAMQA0ADUANgAiADIANwA2ADIAIgAwADIAOAA5ADoAOwA8ADgAOQAxACoAPQA+AD8AOgA5AEAAPgBBAD8APgA7ADgAOwA+AEIAQgBDAEQAOQA4ADQAMQA5ADQAOABBAD4ANAA4ADwAQwBCAD4APQBDAD4ALgBFAEYARwBIAEkASgBLAEwASwBNAE4ASgBPAEsATQBLAE8AQAA5AFAASQBRADkAQwBSAEQALAA5ACoASwBOAEcATgBNAFMARgBHAEkARgBJAC4ASABHAE4AVABMAEsASgBVAE8ATABWAEoAUAA5AFEAVQBXAE8AVgBVAEoATgBTAFgAWQBPAFcAWgBXAFUAWwBNAE8AXABVAFYALAAuADkAOQAuAEkAUwBNAFgAQwBYAE0AWABDAD0ATwBZAFsAXQBNAFsAUgBDAE0AXQBSAE0AXABWAF4AWgBfAFcAVQBgAFoAVgBMAGEAVQBcAGAAYQBMAFQAWQBXAGIAUgBjAEQAZABEAGMAZQBmAGcAWwBoAF0AXQBoAFIAaABjAFIAQgBpADsAagBpAEIAZQBrAGwAZQBnAGsAbQA8AGkAPAA7AGkAbgBtAGkAbwBwAHEAcgBzAHQANQA0AG0ANAA8AG0AKAAnAHUAdgAcABsAdQB3AHgAeQAcAHYAdQAnAHcAHAADAAUAegADABwAdwAnAHsAegB4AHcAegAcAHgAVABLAGEASwB8AGEAfAAQAGEARwB8AEsAAgB9AH4AfgB9AEYAfQBHAEYAAgB/AIAAAgB+AH8AEwB9AAIAEQB9ABMAgQCCAGEAgwBoAGIAXwBiAFcAhACFAF8AhQCDAGIAXwCFAGIAHQCDAIUAhgBgAFwAggBcAF4AVgBhAF4AggBeAGEAHgCBAIcAXwBaAIQAhAAdAIUAhABaAGAAhgBcAIIAhgCEAGAAHgAdAIIAggCBAB4AhgCIAIQAHQCEAIgAggCIAIYAggAdAIgAWwBZAGIAaABbAGIAiQBoAIMAigCDAB0AIACKAB0AiwCMAGQAjQCOAHAAjgCMAIsAjgBzAIwAdABzAI4AYwCLAGQAiwBwAI4AcQCPAJAAgwCKAIkAjwBwAIsAkACPAIsAkACLAGMAjgCNAHQAigAgAIkAcQBwAI8AiQCQAGMAkQBxAJAAiQCRAJAAIACRAIkAiQBjAGgAkgCTAHIAlACSAJUAZwCWAGsAQgCSAGoARABkAJMAjABzAHIAkgByAJUAQgCTAJIAlACVAJYAagCSAJQAbgBqAJQAlgBuAJQAagBuAGkAZwBuAJYAjACTAGQAkwCMAHIAQgBEAJMAbABmAGUAbAAZAGYAGQCXAGYAbgBnAGYAZgBtAG4AZgCXAG0AbQCXAJgAmAAZABcANQBtAJgAlwAZAJgANQCYADEAmQAXAJoAMwCYABcAMwAxAJgAMgAzABcANwAyABcANwAXAJkAfgBFAJsAfgBGAEUAnAB+AJsAnACbAHYAnAB2ABsALgAtAJ0AmwCdAHYARQCdAJsARQAuAJ0AngB4ABwAnwAcAHkAoAChAHUAoAAsAKEALwAsAKAALgAsAC8AdQB4AJ4AngCgAHUALwCgAJ4AogAvAJ4AnwCeABwAnwCiAJ4AoQAoAHUALQAvAKIAnQCiAJ8AnQAtAKIAnQCfAHkAnQB5AHYAowCkACUAowClACEApQArADAAIgA2AKYAowAsACsApQCjACsAowChACwApACjACEApwClADAAIgCnADAAIgClAKcAIQClACIANwCmADYAIgCmACMAIwCmADcAoQCjACgAowAlACgAqACpAKoAqwCsAK0ArQCsAK4ArwCsAKsArwCwAKwAqgCpAK0ACQCvAKkACQAPAK8AqQCrAK0ArwCrAKkACQCpAAgAqQCoAAgACACoALEAfQB8AEcAEAB9ABEAfQAQAHwAHgCyAB8AhwCyAB4AgQBhAIcAGwB+AJwAGwB/AH4AGwCAAH8AGwCzAIAAUQBIALQASAASALQAUABRALQAtQBQALQAOgBAALYAtgBAALUAQABQALUAOAA6ALcAOgC2ALcAPwBBALgAQQA4ALgAuAA4ALcAPQA/ALkAuQA/ALgAFQBYALkAWAA9ALkAFQBOAFgAEgBIAE4AFQASAE4ASQBIAFEAAQC6ABMAAAC6AAEAuwAEAAMAegC7AAMAegC8ALsAvQC+AL8AegC+AL0AvQC/AA4AegC9ALwAwAC/AL4AdwC+AHoAdwDAAL4AwQAnACkAwAB7AMEAdwB7AMAAewAnAMEAwQDCAMAAuwAMAAQAsADBACkAwgDBALAADwDAAMIAvwDAAA8AvQAOAMMAvADDAA0AvAC9AMMAvAANAAsAuwC8AAsADAC7AAoAuwALAAoADgAJAMMACQANAMMADwAOAL8AwgCvAA8AsACvAMIAsAApAMQAsADEAKwAxQDGAMcAyADFAMcAyQAEAMoAyQAFAAQAyQDLAAUAsQDMAAgABgAIAMwAzQDOAMwAzgDPAMwA0AAMAAYAzADQAAYAsQDNAMwAzADPANAAzgDRANIAzgDTANEAzwDOANIA1ADVACQA1gDXANgA2QDaANsA3ADXANYA3ADdANcA2wDFANkA2QDFAMgAFgDeAN8A3gDgAN8AFwAWAN8AGgAZAOEAGgDhAOIA3wDgAOEA4ADiAOEABQDjABsAywDjAAUA5ADjAMsA5QAgAB8A5gDnACAA5gAgAOUA6ADmAOUAIQAjAOkApAAhAOkApADpAOoA6wDsAO0AJAAmANQApADqACYAJQCkACYA1AAmAOwA7AAmAO0A7gDvAPAA8ADvAPEA8ADxAPIA8wD0APUA9gDzAPUA8gDxAPcA9gD1APgA9QD5APgA+gD7APwA+gD8AP0A/gD4APkA/wDwAPQA/QD8AAAB/QAAAe8AIwA3APoAmQCaAPsA9ADwAPIANwCZAPoA7wAAAfEAmQD7APoA7gD9AO8AAQECAQMBBAEFAQYBBgEBAQQBAwHyAPcABwEIAQYBAgEJAQMBBgEIAQoBBQELAQYBAwEMAQEB9wAMAQMBAQEGAQoBDAEEAQEBDQEGAQsBBwEGAQ0B/gAOAQ8BEAERAQ0BEAENARIBEwH5ABQBFQEWARcBGAEZARYBGQEXARYBGQEaARsBHAEaAR0BGAEdARoB9ADyAAMBHgEfARYBAwEgASEB+QADASEBEQEQASIBFQETASMBGgEZARgBEgENAQsBDgH5ABMBDgH+APkAFAEjARMBHgEVASMBFQEeARYBJAEVARcBJAEXASUBFwEZASYBJwEfAREBJgElARcBJgEZARsBCQEgAQMBHAEbARoBHgEjAR8BJwEYARYB9AADAfUAAwH5APUAEQEfAQ0BJwERASIBHwEHAQ0BIQEUAfkAHQEnASIBGAEnAR0BHwEnARYBKAEpARsBGwEpASYBHQEqASsBHAEdASsBHAErASwBKQElASYBHAEsASgBHAEoARsBCwEtAS4BEgELAS4BEAESAS4BLwEQAS4BMAExATIBMwE0AWwAMQE0ATUBNgEiATcBNwEiAS8BMwE1ATQBIgEQAS8BNQE4ATEBMAEyAQUBOQEFATIBMQE4ATkBMAEFAQQBMQE5ATIBCwEFATkBCwE5AS0BIADnADoBcQA7AW8AjQBwADwBPQE+AW8AbwA+ATwBkQA6ATsBdACNADwBPAFwAG8AkQA7AXEAPAE/AXQAPwFAAXQAOgGRACAAQQFCAXIAQgFDAZUAQAFyAHQAcgBCAZUAQwFEAZYARAFrAJYAQwGWAJUAQAFBAXIA9wAwAQwBDAEwAQQBIgE2AR0BHQE2ASoBRQFGAUcB7QBIAesARgFJAUoBRQFHAUsBRgFKAUcBSAFFAUsBSQFMAeQASQHkAEoBSAFLAesA5ADLAMkATQHrAEsBTgFNAUsBTwHkAMkATQFQAesATgFLAUcBTwFKAeQATwFHAUoBTwFOAUcBJAFRARUBUgFRAVMBFQFRAVIB2QBUAVUBVAEOARMBVQFUARMBswBWAcgAyABWAVcByABXAVQB2QDIAFQB2gDZAFUB2ADaAFUBKwFYASwBWQFaATYBKwEqAVoBWAFaAegA6ABaAVkB5gDoAFkB6ABbAVwBWAErAVoBKQFRASUB5QBdAVsBUQEkASUBXAEsAVgBXAFeASgBKQEoAV4BXAEoASwB6ADlAFsBKQFeAVEBXgFdAVEBWwFdAV4B6ABcAVgBXgFcAVsBNgFaASoBNwFZATYBXwFZATcB5wBZAV8B5wDmAFkBYAFhAUABYAEuAWEBPgEuAWABPAFgAUABPwE8AUABYgFjAT0BXwE3AWIBPAE+AWABZAEvAS4BZAEuAT4BXwFiAToBPgFjAWQBOwFiAT0B5wBfAToBPQFjAT4BYgFkAWMBYgEvAWQBbwA7AT0BOgFiATsBNwEvAWIBQgFlAUMBOQFlAS0BQwFlAWYBMwFEATUBZwFEATMBLQFhAS4BQQFAAWEBZQFCAUEBZgFlATkBQwFmATkBOAFDATkBNQFEAUMBNQFDATgBZwFrAEQBMwFsAGcBbABrAGcBLQFlAWEBQQFhAWUBNAExAWgB4QA0AWgBNAHhAGkB4QAZAGkBbAA0AWkBaAExATABaQEZAGwAMAFqAWgBagEwAfcAaAFqAeEA3wDhAGoB9wDxAGoBFwDfAPsAmgAXAPsA3wDxAAABAAH8AN8A8QDfAGoB/AD7AN8AVAFrAQ8BVAEPAQ4BbAFrAVQBbAFMAWsBbAHkAEwB4wDkAGwB/gBtAW4BawFMAW8BawFvAW0BDwFrAW0BDwFtAf4AcAFIAe0AcQFGAXIBRgFxAUkB8wD2AHABcwFFAUgBRgFFAXMBcwFIAXAB9gBzAXAB+ABzAfYAcwFyAUYB+AByAXMBbgFxAXIBbgFyAfgAbwFJAXEB/gBuAfgAbQFvAXEBbQFxAW4BTAFJAW8BdAHtACYA7gDwAP8AdAHqAHUB6gD/AHUB/wD0AHUB6QAjAPoA6QDuAOoA8wB1AfQA6gDuAP8AJgDqAHQB6QD9AO4A+gD9AOkAcAHtAHUBdQHzAHABdQHtAHQB0wB2AXcBdgF4AXcBdgF5AXgBeQGtAK4AqACqAHoBeAF7AXcBqgCtAHoBegF2AdMAegF5AXYBegGtAHkB0wDOAHoBzgDNAHoBegHNAKgAzQCxAKgAUgHYAFUBVQETARUBUgHWANgAUgFVARUB5QB8AX0BHwB+AXwB5QAfAHwB5QB9AVEBXQHlAFEB4wBsAVQB4wBUAVcB4wBXAVYB4wBWAbMA4wCzABsAfwGAARQBFAGAAdcAgQGAAYIBggGAAX8BgwGBAYQBhAGBAYIBAgGFAYYBhQGHAYYBhwGDAYYBhgGDAYQBAQGIAQIBAgGIAYUBCgGJAQEBiQGIAQEBBwGKAQgBigGJAQgB3QCLAR8BHwGLAQcBiwGKAQcB1wAfARQB3QAfAdcAhgEJAQIBhgGEAQkBiQEKAQgBggEgAYQBhAEgAQkBfwEgAYIBfwEhASABIQF/ARQBIwEUAR8B2wDaAMYAxQDbAMYATwHKAIwBTwHJAMoATgFPAY0BTwGOAY0BjAGOAU8BTgGPAZABjwGNAZEBjwGSAZABjwFOAY0BTQFOAZABkwHTAFABlAHsAOsATQGTAVABkAGSAZMBTQGQAZMBUAGUAesAjAHKAAwAygAEAAwAUAHTAJQBjwGVAZIBjwGRAZUBjQHPAJEBjgHPAI0BjAHPAI4BDADQAIwBjAHQAM8A0gCVAZEB0gCRAc8A0gDRAJUBkwHRANMA7ACUAXcB0QCSAZUBkgHRAJMBdwGUAdMAlgF4AXkBeAGWAXsBeQGuAJYBlwGYAZkB4gCaARoA3gCbAZwB4gCcAZcBGgCaAZkBGACYARYAGgCYARgA4ADeAJwBlwGcAZgBmwGYAZwBmQGaAZcB4gCXAZoBFgCYAZsB3gAWAJsB4gDgAJwBGgCZAZgBxwCdAcgAyACeAbMAnwECAIAAoAF9AXwBoQGHAGEAogGyAKMBowGyAIcAUQGkAVMBgACzAJ8BxgCdAccAyACdAZ4BAAACAJ8BAACfAboAogF+AR8AoAGlAX0BoQGmAYcAhwCmAaMBpQGkAVEBogEfALIAoQFhABAAfgGgAXwBpQFRAX0BpwGfAbMA",count:801},{rgb:[.251,.251,.251],positions:"JQCI/CD/LwCN/DH/LACJ/D7/IgCO/Fj/IACI/FL/DgCN/GT//P+K/GT/0f/a/Fn/xv/d/Dz/1P+T/E7/GwAK/WX///+u/G3/HwDA/GX/0v8J/VT/zP8K/UX/2f+J/Eb/0f+N/DP/yf+1/Df/AwAJ/W7/DQAK/Wj/yf8K/Tj/x//n/Cr/z/+7/Bv//f/Z/HD/6//l/G3/6f+P/GD/1/+K/CH/5P+2/Gb/6f8K/Wb/0f8K/Rv/4P/b/Gf/LQDy/Fr/LAC2/Fr/NQDX/E7/MAAK/VD/IwAK/Vr/5f/H/AT/8/+S/Af/2P+4/A7/4v8J/Qj/9v/l/Pz+/v8K/QD/MAC0/Br/MAAK/Rv/OgDg/C3/OAC6/DP//P/D/P7+//+L/An/NwAK/Tf/EwDO/P/+MACg/En/HAC8/Ab/HAAK/Qf/HACO/BD/0P/W/Bb/5v+J/BP/2P/o/A3/LwDm/BT/LwAK/UH/LgAK/Sb/AgAK/Qb/9/88/WT/2P83/U7/5/81/Q3/AQA1/Qb/0P81/Tb/IAA1/RL/1v85/Sf/3f86/Rv/9/89/Qf/AQA4/Qv/8f86/Q3/FgA3/RD/2f9H/VX/0f89/Tn/0f9Q/S3/0f9Q/UD/3P9Q/Rb/7v9Q/Qr/CgBQ/Qb/1v9X/Uj/0/9X/Sr/9f9T/Qv//P9c/QP/EABS/Qz/4f9Y/RL/0v9Y/Ub/2v9h/Vn/7/9X/WD/IQBW/Rf/DQBh/QP/z/9s/S7/4P9r/Q7/2v9x/VT/z/9r/UH/yv9+/Uj/8f9t/Qn/5P9u/RD/5v9z/Qr/AwBy/QX/zv9z/ST/1P9x/ST/EwBs/Qj/8/98/W7/6P9w/V//9P9j/Wv/FQBz/Qf/IgBy/RH/1P+G/Vb/9/+G/QL/EwCG/QP/zv+L/S3/3f+J/RD/5/+M/WL/GwCA/Wf//f9z/Wr/3/+O/WL/yv+O/T//1f+K/VH/EQCN/QP/FACJ/Qj/2v+O/Q7/yv+O/Sr/8/+O/QH/+P+M/QT/IgCG/Q3/6f+G/Qb/x//1/SL/0P+S/VH/+/+s/f3+4v+4/QX/CwAJ/vz+yf/3/Sn/zf85/lf/FAA4/v/+HwCw/Qb/6P/3/W3/4/8p/mf/7v80/m3/+v82/v3+5/85/gL/5f/4/QT/4/8r/gT/yv8o/hv/y/80/h//yf8p/ir/x/85/i3/IAA8/Vj/DAA1/Wf/LAA1/ST/LwA1/Tz/CgA2/WL/JQA7/R7/LQA9/ST/MQBC/TX/KgBY/Uz/LgBQ/UT/KQBQ/Rz/DwBY/WP/9f9Q/WX/LABT/S//MgBe/Sj/HQBY/V7//f9V/WL/MgBr/Tv/KQBs/VP/GwBr/WL/KgBr/Rr/AwBv/WX/FwBw/WD/MgB8/VD/LgBx/UT/FABz/Wb/LABy/SL/NwB9/Sj/NQCH/Tb/GwCM/WL/8/+O/Wz/AQCI/Wr/JwCL/Rb/LQCO/Vf/LQCJ/Uz/OACP/S7/HQCO/WX/JwCO/RD/JQCr/WP/NACx/U//EQD3/Wz/LQC0/RP/CQAh/nP/OQD3/TT/KwAo/hL/IwD4/RL/JwAq/g3/9P8q/m7/GQA4/gb/MAAr/hv/OQAz/if/OQAl/jD/FQA5/mn/+v82/nH/EQAs/m7/JwA5/l3/OQA5/kD/OQAr/jb/5//4/Qr/5v8p/gn/3v8l/gj/z/83/ij/1/8s/g//DwAq/mn/AAAs/m//5v8q/mP/5v/4/WL/CwA7/g3/+v84/gT/FAA4/lv/3v85/lz/MwA0/jT/MQA5/ij/z/85/kP/BgA0/gH/BgAT/gH/5/8j/g7/0P8o/if/1v/3/S//0v8f/ir/1/8s/hj/LwAj/jX/MgD4/TT/IgAf/hT/IQAq/hD/6v8e/mD/6/8o/mT/DQAf/mT/EgD3/V7/+v8s/mn/2//4/Vb/0P/4/UT/0P/4/UT/9f/3/Qb/1v/4/Rn/1f8R/hf/MgAQ/iP/EAD4/Qn/LgD4/Un/JwD3/U//IgD4/Vr/AgAM/m7/BQD4/Wj/5P84/lb/9P/3/Q7/4P/w/R//5f/3/Rf/2v/x/Ur/4//2/VT/9//2/V//FwDc/VH/GQDc/Vb/GgD2/Vb/BgDc/V//FgDc/RT/JgDc/Sj/GwD3/RX/KgD3/S7/+//b/Vz/5P/c/VT/IgDb/S3/HwDb/UP/BAD3/Q3/7//c/RH////c/Q7/1//c/Tv/2f/c/S3/7f/c/Sf/DADg/Sr/6P/T/UD////c/UP/9v/c/S7/6P/b/T7/BgDb/R3/CwDc/TT/+/8H/kv/7v8F/i7/7P8F/if/8f8H/in/EQAG/jD/+v/U/TL//v/U/Rv/BwDU/TP/EgDT/Uj/EAAE/iv/CwA1/HT/EQAe/Ir/DwBB/GT/CQBH/Dn/EwBG/EX/AQAs/Ef/EgBy/ET/AAA7/HL/DwCM/Cn/BgBv/Cf/EgAN/MH/FQD9+/r/FAAC/KP/BQB7/E3/EgAZ/Gj/BQDx+63/AwD6+47/BgAd/KT/9/8c/Kf/BgAZ/Ln/+v8R/Gf/9P9//Ez/+/9A/I8A8/8r/IEA8P8+/JcA7P8G/GEA8v/1+z8A/f/x+1MA/P8H/IcAAgD++3QA7v8Q/FIA6/8c/IEA8f8S/I4A+P8b/FYABQAS/JgACQAc/FsACQAY/EQA+v83/LwA7/85/LEAFgDW/Df//P+O/CL/7//V/CP//v/W/CD/DQD4+1kA6/8K/KH/7//4+7z/CQA3/LoAEQAf/JcAFAA8/KcACgBA/JEAEgAR/FAAFAAL/GkAEwAk/IUA8/8U/L//7/9m/Ev/7P9T/Eb/9P9C/Gf/9P9h/FP/7v86/Ev/7f8V/Hr/8f8m/Ib//P9R/DH/8f8A/JD/8v9w/Cv/7P+B/DH/7//W/EP/AwDU/En/",indices:"AAABAAIAAwAEAAIAAwAFAAQABgAEAAUABwAIAAkACgALAAwADQAOAAcADwAJABAADAALAAUACAARAAkACgASAAsACQARABAABwAOAAgACgATABIABQALAAYADgAUAAgAFAAVABEAEQAVABYAEQAWABAAFwASABgAFwAYAAsACwAZAAYAEAAWABoACwAYABsACwAbABkAHAAYABIAFAAdABUAFgAVAB0AGwAeAAcAHwAgACEAGwAJABkAHgAcAA0AGwAHAAkAIgAjAB8ADQAHAB4AIAAMAAMAAwAMAAUAHwAMACAACgAfACMAHwAKAAwAJAAlACYAJwAoACQAKQAoACcAKgArACwAKgAtAAAAKgAsAC0AJAAoACUAKAAuACUAAAAtAAEAJQAuAC8AKwAwACwALgAxAC8AAQAtADIAKQAxAC4AAQAyAAIALQAwADIAMQAzAC8AKQA0ADEAMAAhADIALwAzADUAAgAgAAMAMgAgAAIAMgAhACAAGgAWADYAIgAhADAAGgA2ACYAGgAmADcAHQAnADYANgA4ACYAMwA0ADkAMwAqADUANQAqAAAAOAAnACYANAArADkAJgAlADcANgAnADgAMwA5ACoAMwAxADQAKgA5ACsAAAAvADUAGgAPABAADwAGABkACQAPABkAJQAvADcAKQAuACgAGgA3AAIADwAEAAYAGgACAAQANwAvAAAANwAAAAIAGgAEAA8AIwATAAoAEwAcABIAOgAjACIAMAA6ACIADgANABwAOwA6ADAAKwA7ADAAHQAUAA4AKwA0ADsAKQA8ADQAKQAnAB0AKQAdADwAHAA9AD4ADgAcAD4APAA/AEAAPAAdAD8AHQAOAD4AHQA+AEEANAA8AEAANABAAEIAHQBBAEMAHQBDAD8ARABAAD8ARQBGAEcASABCAEAASQA+AD0ARgBAAEcASgBDAD4ARQBIAEYAPgBDAEEARQBHAEQASABAAEYARwBAAEQARAA/AEMASwBDAEwATABDAEoATQBDAEsATQBEAEMATgBFAE0ATQBFAEQATAA+AEkATwBFAE4ATwBIAEUATABKAD4AUABMAEkAUQBNAEwAUgBOAE0AUwBUAFIATABNAEsATgBSAE8AVQBNAFEAVABPAFIAVgBRAFAAUQBMAFAAVwBJAFgAUgBNAFUAWQBTAFoAVgBQAFcAWQBUAFMAUABJAFcAWwBVAFEAXABVAFsAUwBSAFwAXABSAFUAXQBWAFcAXgBWAF0AWwBWAF4AWwBRAFYAXwBbAF0AYABcAGEAYgBjAGEAYwBgAGEAZABiAGUAYgBhAGUAYABTAFwAXQBbAF4AYwBmAGAAZQBcAFsAZgBaAGAAWgBTAGAAZwBdAGgAaABXAGkAYQBcAGUAZABlAF8AaABdAFcAagBrAGMAXwBlAFsAbABdAGcAbQBjAGIAbgBqAGMAbwBwAGQAcQBsAGcAXQBsAF8AcgBnAHMAbwBkAF8AdAB1AHYAdwB4AG0AbQB4AG4AeQBvAHoAeQBwAG8AbwB2AHUAeQB7AHwAfABwAHkAbgB4AH0AdgBfAGwAcABtAH4AbwBfAHYAfABtAHAAdQB6AG8AdAB2AHEAdgBsAHEAfAB3AG0AewB3AHwAegB/AHkAgAB1AHQAewCBAHcAeQCCAHsAggCBAHsAgQCDAHcAegCEAH8AhQCAAHQAhgCHAHcAiACFAHQAhgB3AIMAhQCIAIkAigCFAIkAiwCDAIEAiwCBAIIAjACLAIIAjQCMAIIAjgCMAI0AjwCCAHkAjwCNAIIAkACMAI4AjwB5AH8AkQCEAHoAkgCQAJEAkgB6AHUAkgCRAHoAhQCSAHUAhQB1AIAANgAWAB0AHwAhACIAFwALABIAHgAbABwAGwAYABwAMAAtACwAJAAmACcAEQAIABQAIwCTAJQAOwA0AEIAEwAjAJQAOwBCAJUAOwCVAJYAHAATAJQAOgA7AJYAHACUAD0AIwCWAJMAIwA6AJYAlwCUAJMAmACVAEgASACVAEIAmQCaAJgAmACWAJUAmgCWAJgAlwA9AJQAmQCYAEgAmwCWAJwAmwCTAJYAnQBIAE8AngCTAJsAnQCZAEgAngCXAJMAngA9AJcAmgCZAJ0AnwA9AJ4ASQA9AFgAWAA9AJ8AnACWAJoAoACdAFkAoQCcAKAAogCeAJsAowCfAJ4AoACaAJ0AWQCdAFQAnACaAKAAVACdAE8AVwBYAGkAaQBYAKMAowBYAJ8AoQCgAFkApACbAJwApQCbAKQApgCbAKUApgCiAJsAZgBZAFoApwBZAGYApgCeAKIAaQCeAKYApwChAFkAaQCjAJ4ApACcAKEAaABzAGcAaABpAKgAqQCmAKUAqgCpAKsArACoAKkArQCkAKcAqwClAKQAcwCsAHIAqQCoAKYAawBmAGMArgCrAK0AqABpAKYAqwCkAK0AqQClAKsAcwBoAKwArACpAKoArABoAKgApwBmAGsArQCnAGsApwCkAKEAqgCrAK4AcgCsAKoAbgBjAG0ArwCqAK4AagBuAGsAbgB9AGsAfQCuAGsAZABwAGIAawCuAK0AfgBiAHAAbQBiAH4AsAByAKoAsQB0ALIAfQCzAK4AtAC1AK8AdABxALIAtQCqAK8AsgByALAAsgBxAGcAtgCvALMAtwCyALAAuAB4AHcArwCuALMAtACwALUAtACvALYAuACzAHgAsACqALUAsgBnAHIAswB9AHgAtwCwALQAtgCzALgAtAC5ALcAtAC6ALkAdwCHALgAuQC7ALcAhwC8ALgAtwC7AL0AtwC9ALIAuAC8ALYAvQCxALIAvQCIALEAsQCIAHQAvgC6ALYAugC0ALYAvwC2ALwAvwC8AMAAwQDAALwAwgCIAL0AwQC8AIcAhgDBAIcAhgDDAMEAxADDAMUAxADBAMMAvwDGALYAxwDIAMkAxwC7ALkAxwDJALsAygDHALkAygC5ALoAywDKALoAywC6AL4AzADLAL4AxQDLAMwAxgC+ALYAzQDOAI4AjQDNAI4AzwCNAI8AhACRANAA0QCOAM4A0QCQAI4AuwDJANIA0wDSAMkAyACKANMA0wDJAMgAiQDUAIoAiADVAIkAhgDWAMMAhgDXANYAiwDXAIYAjACQANcAiwCMANcAigDIAMcA2ADHAMoA2QCFAIoA2gDKAMsAxQDaAMsA2wDaAMUA3ACFANkAwwDbAMUA0ACFANwAkgCFANAAkACSANAAiwDdAN4A3QCLAIYA3gDdAIMA3QCGAIMAiwDeAIMAjQDfAM0AjQDPAN8A3wDPAI8AjwDgAN8A4QDiAH8A4gCPAH8A4ACPAOIAhADhAH8AkQCQANAA0ACQAOMAkADRAOMA0QDOAOMAvgDkAOUAvgDGAOQAxgC/AOQA5gC/AMAAwQDnAMAA2gDEAMwAxADFAMwA5wDBAMQA2gDMAOUA5QDMAL4AiADoANUAiADCAOgAwgDpAOgA6gC9ALsAwgC9AOoAuwDSAOsA0wDsANIAigDsANMA1ADsAIoA1QDZANQA1ACJANUA4wDOAJAAzgDXAJAA2QDtANwA7QDuANwA3ADuANAA7wCEANAAzgDNANcAzQDwANcA4wCQANAAzQDfAPEA3wDyAPEA8gDiAPEA8QDiAOEA5ADzAOUA8wDmAMAAxADaANsA9ADAAMMAwwDAAOcA5QD1ANoA2gD1AMoA5wDEAMMA9QD2AMoA9gD3AMoAxADbAMMA9wDrAMoA6AD4ANUA+ADqAPkA+QDqALsAxwDrANIA0gDsAMcA7ACKAMcA7ADZAIoA7ADUANkA2QD6AO0A8wDAAOUA2ADKAOsAwwDWAPQA1QD4APkA6ADpAOoA6QDCAOoA+gDZANUAxwDYAOsA8ADNAPsA8QD8AP0A7gDtAP4A4QDuAP4AhADvAOEA8QD9APsAzQDxAPsA8QDhAPwA/gDtAP8A/wDtANUAAAH/ANUAAQECAQMBAwEEAesAAgEEAQMB6wAEAQABBQEGAQcBBwEGAQgBBAEJAQABCQEKAQABBgELAQgBCAEMAfYACwEMAQgBDAEBAfYA9gABAQMB4gDyAN8A5gDzAOQAAwHrAPcABwEIAeUAwAAHAeUAAwH3APYA9AAHAcAA9gD1AOUACAH2AOUA6gD4AOgA6wD5ALsAAAH5AOsAAAHVAPkA9ADWAA0BDQHWAPAA1gDXAPAA7QD6ANUADQEHAfQADQHwAPsA4ADiAN8AvwDmAOQA/QAOAfsAAAEKAf8ADgEPAfsACgH+AP8A+wAPAQ0B/gAQAeEADwEFAQ0BDQEFAQcBEAERAeEAEQH8AOEA/AAOAf0AEAH+AAoBDgESAQ8BBgETAQsBBQETAQYBAQEJAQQBDgH8ABIB/AARARIBFAEKARUBFQEKAQkBEgERARYBFgERARcBEQEQARcBBQEYARMBDwEYAQUBFwEQARQBFAEQAQoBCwEZAQwBEwEYARkBAQEEAQIBDwESARYBFQEJARoBEgEbARwBEgEWARsBEgEcAR0BEwEZAR4BFwEUAR8BFgEXAR8BIAEWAR8BDwEWASABGAEPASABGQEYASEBDAEZASEBAQEMASIBFQEBASIBFQEiARQBAQEVARoBCQEBARoBFgESAR0BFgEdARsBCwETASMBCwEjAR4BGQELAR4BIQEiAQwBFAEiASEBIAEfASEBIAEhARgBHQEcARsBIwETAR4BFAEhAR8BJAElASYBJwEoASkBJgEoASoBJgErASQBLAEnAS0BLAEoAScBLgEvATABMQEmASoBMgEzATQBMgEwATMBNQE2ATcBJQE3AS4BJQEuATABMgE0ATgBNQE3ASUBNQEkATYBKgEoASwBKQEyATgBMQE5ASYBJgElATABJgEwASgBKAEwATIBKAEyASkBJAE1ASUBOgE7ATwBPQE+AT8BQAE/AUEBQgE9AUMBRAE/AUABRAE9AT8BOwFFAUIBRAFDAT0BRAFAAUYBRwFIAUUBSQFEAUYBOwFCAUMBOgFFATsBSgFEAUkBKgEsAUsBTAFNAU4BLQFMAU4BLAFOAUsBLAEtAU4BTwEzATABLwFPATABPQFQAVEBPgE9AVEBPgFRATMBPwE+ATMBTwE/ATMBUgFTAVQBSQFGAVIBVAFVATwBVgFIAUcBTwEvAVcBOgFHAUUBWAFWAUcBWAFXAVYBQQE/AU8BVQFHAToBWAFHAVUBUwFPAVcBVwFYAVQBRgFBAU8BRgFPAVMBQAFBAUYBUwFXAVQBOgE8AVUBUgFGAVMBQgFFAVABPQFCAVABVwEvAS4BVgFXAS4BSAEuATcBSAFWAS4BSAE3AVkBRQFIAVkBRQFZAVABWgFbAVwBXQErASYBKQE4AV4BNgFZATcBXQFcASsBXgFfAVsBXwFgAVsBUAFZATYBYQEpAV4BXQFaAVwBYQEnASkBYAE2ASQBOQFdASYBYgFRAVABWgFdATkBYQFeAWMBMwFRAWIBYQEtAScBKwFgASQBYwFeAVsBYAFQATYBYgFQAV8BXAFgASsBOQFbAVoBZAFbATkBYwFbAWQBNAEzAWIBTQFjAWQBOAE0AWIBXwFQAWABYwEtAWEBTAFjAU0BTAEtAWMBWwFgAVwBXgFiAV8BOAFiAV4BOQFlAU0BZAE5AU0BMQEqAUsBMQFLAWYBOQExAWYBOQFmAWUBSwFOAU0BSwFlAWYBSwFNAWUBSgFJAVIBSgFUATwBUgFUAUoBQwFEAUoBOwFDATwBWAFVAVQBPAFDAUoB",count:720},{rgb:[.902,.922,.929],positions:"Yf///+7/iP9oAOz/dP81AOf/6f88AQoAMgAxAQAAbf8aAQcAzwChAAIAqgCSAAEArwCMAEEAxgDLAAEAvwDPAEEA0ACwAEEAXf8AAAAAs/+RAPX/hP+g/+r/p/93/wAA9/9Y//f/FP/I/0sAQP8hAEsAHf/M/ygAOP/o/ygAOf8cACgA//45ACgAFAHL/0sAMAEiAEsAHwHS/ygAJwErACgADAHg/wAADAHe/ygADgEfABsAEf/e/wAAJP/p/ygAJv/8/wAAHP8cAAAACf8lACgAJAF7AAoA+gDRABoAOAFLAEoANQEvAAIAOQGi/yYABgFN/woArQD2/kQAlADl/goAmQCcAAAAOACbAAAAkQCzAAEAMgH1/wAA2P5nAAMADv/KAAQA2wDx/wAAngAnAAAA6QAfAAAAEwDM/gAAuP/N/gcAB/88/wQAIgGf/wAAN/8O/wcAzQAU/wAAgACa//7/wQDjAP7/BwGdAAAAzf77//7/x/4QAAMA7v4ZAAAA5v7w/ygA1gD+/ygASQAcAgsAfwBGAQoA9f/k/QsAgf+6/goAigArAUsAfgBKAUsAlQAcAUsA+gBM/0sAKgG5/0sAzgDZ/0sApQD8/k8AwwD2AEYAzQAqAEsAKv8W/z0A5f5z/0EAyf7I/0EAyv74/0kAzv5PAEEABf/FAEAAbP8cAUsAJf/VAEsAXP8FAU8A3/5tAEsA4v4sAEsA0v7e/0sA/P5Z/0sAWP///k0Azf8cAgsAgv9MAQoAcv/c/goALwDI/goAfgC0/goA7wDK/ygA0ADa/ygAwwD7/ygA7gA2ACgAxQAQACgA1AApACgA1/4fACgA1f7b/ygAEQBl/+v/SAB0//H/hQCq//L/lQDb/+n/ngAIAPH/kwAwAOr/gwBZAPH/aAB3APH/VwCCAOf/IwCaAPH/YACM/+f/av/m/lsAav8WAWQAav/q/mUAoAAJAVIAlgAWAWUAlgDq/mQAgv9KAUsAbP/k/ksAgv+2/ksAfgC2/ksAlADk/ksAjwAiAQoAlADAAEEAngDKAAIAmQBa/XkAmQCiArwAmQBT/QgBmQC2AoYAmQCjAnMAmQA8/f0AmQAw/eMAmQDQAt0AmQDFAvwAZ//QAt0AZ/+iArwAZ//PAugAZ/+jAnMAZ/+2AoYAZ/9o/W8AZ/9c/XMAZ/9L/YQAZ/8w/eMAZ/9T/QgBZ/88/f0AZ//FAvwA",indices:"AAABAAIAAwAEAAUABgAHAAgACQAGAAoACgAGAAsACwAGAAgADAANAAEADAABAAAADAAAAA4ADwAMAA4ADwAOABAAEQASABMAEwASABQAFQASABYAFAASABUAFwAYABkAGQAYABoAGwAcAB0AHgAfACAAIAAfACEAHwAiACEAIwAkACUAJgAjACUAJwAmACUAKAAnACkAKgAoACkAKwAsAC0ALgAdACYAIQAvAAwAIAAhAAwADAAvAA0ALwAwAA0ADQAwAAUAMQAyADMAHQAzACYANAAPABAANQAPADQADwA2AAwANwAbAC4AOAAPADUAOQAQADoALQAEADsALAAEAC0AMwAGACYAJgAGADwAMgAGADMAOQA6ADcAPQA+AD8ABgAJADwAGwAdAC4AMgAHAAYANwA6ABsANgAPADgAPAAJADsANgAeAAwAMgArAAcALAAFAAQAGwA6ADEAHgAgAAwAPQAeADYAMgAsACsAPgAvAD8APwAvACEANAAQADkADQAFACwAOgAyADEAPQBAAB4AIQAiAD8AQAAfAB4AIgBAAD8APwBAAD0AMQAcABsAQQAcADEAHQBBADMAMwBBADEAAwBCAEMARABFADUARgBHAEgAFwBJAEoASwBJABcASwBMAEkATQBMAE4ATgBMAEsAJQBOABgAFwBKABgATQBOACUANgA4AE8ANgBPAFAAPQA2AFAAPQBQAFEAPgA9AFEAPgBRAFIAPgBSAFMALwA+AFMALwBTAFQAMAAvAFQABQAwAFQABQBUAFUAVgASAFcAWAASAFYAWABZABIAWABSAFkAWgBbABEAEgBcAFcAEQBcABIAEQBbAFwAAwBdAEIAXgBdAAMABQBeAAMAXwA4ADUARQBfADUAYAAqAGEAHAAZABoAHQAcABoAHABiABkAHABjAGIAQQBjABwAZABjAEEAZQAdABoAZgBkAEEAZwAdAGUAZwBmAEEAZwBBAB0ATgBLAGQAGABOABoAGgBOAGUAZABLAGMAZQBOAGcAYwBLAGIAZwBOAGYASwAXAGIAYgAXABkAZgBOAGQAaAAiABYAHwATABQAHwAUABUAQAATAB8AQABpABMAIgAfABUAFgAiABUAaABpAEAAaABAACIAEgBZABYAFgBZAGgAUgBaAGkAWgARAGkAaQARABMAWQBSAGgAaABSAGkAEABqAGsAEABrADoAOgBsAG0AMgA6AG0AMgBtAG4AMgBuAG8AMgBvAHAALAAyAHAALABwAHEALABxAHIALAByAHMALABzAA0AbQByAG8ADQByAG0AAgABAA0AdAANAG0ADgAAAAIADgACAA0ADgBqABAADgANAHQADgB0AGoAVwB1AHYAVwBcAHUAdQB3AHYAeAB5AHoATAB4AHoAeABMAE0AewAFAFUAXgAFAHsAdQA4AHwAOABfAHwAXwBFAHwAfABFAH0AfgAqAH8AYQAqAH4AfwAqACkATQAkAEgAJACAAEgASACAAEYAgABDAEYARgBDAEcAgQCCAAoAggAJAAoABwArAAgAKwAtAAgACAAtAIEALQCCAIEAgQAKAAsACACBAAsAVQBXAHYATwBcAFsAUABPAFsAUQBbAFoAUQBQAFsAUgBRAFoAUwBSAFgAVABTAFgAVABYAFYAVABWAFcAVQBUAFcAXABPADgAdQBcADgAKQB6AH8AKQBMAHoAJABNACUAJQAYAEoAJwAlAEoAJwBKAEkAKQAnAEkAKQBJAEwASAB5AHgAeABNAEgAYAA1ADQAKgBgADQAKgA0ADkAKAAqADkAKAA5ADcAJwAoADcAJwA3AC4AJgAnAC4AIwAmADwAJAAjADwAJAA8ADsAJAA7AAQAgAAkAAQAAwCAAAQAdABrAGoAdAA6AGsAdABsADoAbAB0AG0AbwBuAG0AcgBwAG8AcgBxAHAAcgANAHMALQA7AIIAOwAJAIIAYQBEAGAARAA1AGAAAwBDAIAAgwCEAIUAhgCEAIcAhQCIAIkAiQCDAIUAhgCKAIQAigCLAIQAjACNAI4AjwCNAJAAkQCSAJMAkwCUAJUAlgCVAJQAjQCXAI4AkACNAIwAkQCTAJUAlQCNAJEA",count:263}],link0:[{rgb:[1,1,1],positions:"cgDbAu0CYgC+AnsAxADkAmYANQC3AlkDIgDTAi8DegDoAmQATQDjAjMDIgJC/+MCJwIAAHcFFgJ+/3gFKwLc/yUEsP/Y/XgFdwDc/RcE4AAR/mQF3QHy/ncFtQG0/nUFhwFn/nkD5QHn/tEDSQFI/ngFiAGL/lUFOwLT/xMDWgLB/+oB/QG+/vkBWAJh/44BJALA/kwBvwKH/w8AoQIS/w0AewK0/g0AeAIXAFYBBwIS/goAyQIvAA4AzwJGAA4AQP/F/FEAQv8H/UsAPf/l/GAAev8y/WIAlP+M/FIAUf+p/F8ARf+8/F8Alv84/VEAhvxF/VoAdvxI/QAAbvxv/VoAovyD/QAAbvyWAloAkPyeAgAAhfy7AloAkfyAAlsAv/8pAwAAwv/2AjQAqv9OAy4A2f8A/U0Asv+k/AEAfv8U/QAAd//PAmIAk//IAlEAPf8lA2AASv9NA18AR/8xA0wAZv9pA18Alv96A04AQftrACIAWfw8AB8ArPtp/yIAeP4TABYAeP6c/xYAQf7X/xQACv4TABgACv6c/xgAkf6V/TkBiP6W/VsBQP6d/TIB9/wqAoUBCP0xAkoB8PwoAmUBQvtJ/hQA8frW/x4Aw/9UAhAAzf2c/xkAaP17ABgAbP9n/RIAkP6c/xUAsf95/QsABP1SAhwAQvu1ARQAmf+VAgMAuf95AggA9vqYAUsAyfrZAVAAyPq6ATYAVvqKAU0APvqKAVgAYvr4AVUAd/pGAVEAzfpHAU4A4/9ZA1kArPq7/k8AUPqh/lYA3/p6/iUAUvpr/lMAiP6S/Y8CQ/6c/VQCg/6X/XMCQP6d/WMBu/wrAqEBzvwkAlwBrv1CAvIBEf5SAq0BGv5YAkIBYP09AuMBbPvv/oICcftJ/5gCL/vO/2MCKvsy/zECSfvR/kwCwvsI/kUCvfsy/msCgftH/koCzfrA/+YABPvQ/wMC4PoHAHkB0/1j/uwDPf29/sYDBfvt/p4BLv4F/rYDfP1a/zIEH/3x//4D9vp9/7QBf/uK/nQCkfsS/gMCWPss/p8BNftk/rIB4frd/mwAAPt7/nEA1fr/AGMAxvoaAHwAVfulAIACkP0+AFoEfvs2AYoC+/oKAWwBL/uxAUgBCvuaAXQAgf3qACEEmP0xAREEgvt/AW8CRvtdATUCGfveAAkCLfvAAD4Czvv7AUkCGf4hAmwDzf1RAtoCsfvIAWoCLPtXAeEBi/u3AVQCZfvSAecBAftFAPMBdfu3AS4Ci/vpAQcCPvvIATcB4f2nAe8Def36AUoD5fphAWEAtPo7AGIALPpuAVIAH/qQAQcAE/rjAFQADvr+/10A8vkbAAUAh/o2AlYAwvqVAlQAX/osAhcAYPsQAlkARvvuAV4Aevv6AWcA8/qiAVsAW/vnAX0AJvvBAXoA5/+mA1gAIfvKAgMA4PqoAk0AAQCiA2AAcfvSAQAAxP+t/QAAgf9m/QAAb/sv/gAAA/sZ/wAADvsvAQAAaf/O/AAAZvp5/gAAWvo2/lQAyPo1/kwAZfqJAQAAm/q+AQAAaf8yAwAAbf/9AgAAAACyAwEAsfqYAgAACPrp/gQACfp3/1QAL/pD/gUAJPq3/lMApfpo/Q4Aa/rA/QYAqvpy/QAAqPyxAloAqvyOAlsA8v9Y/FUACPs//QIAqPx1/VsAqvxS/VoApPxM/QAABwBd/F8AJvtO/VUAzvpd/U4Ar/qB/VMAPvpc/lUAWvoT/lMAxPqn/28AzPpQ/20ArvrM/2AA9Ppw/mAA3fqo/l0Azfro/l4A6/pO/lkA8v+3/GgANPsO/lsAWfsX/m8AL/sz/nUAevsS/qwBTfsp/j8Bb/sS/tIAkPzd/cQBC/5bAsABfPvuAbUBlf26/2AEdf4N/gcEP/5X/lYEGP5L/hQEE/4N/3gF2/2w/3gF5P1H//EEPf6U/s4EFv6N/mwEQf7A/ngFBP7e/r0Em/4l/oIErP2x/hAE0v2P/+AEs/3B/5UEv/1F/4AE0f3t//4Eev6D/nIFsP0h/1kE5/3X/noEgP6T/Q8DNv4uAXYFnf6nAXgFZf6aAckEP/7OARME+v2FAS0E/P0XAbcE+f21AHcFMf5yAaoEvP1wAJcEu/3BAHMEzP02AUEE6v1uAGsF5f23AOcEZ/7+AdwDoP7YAZsE/v7iAXAF0/51AisD8/9OAssD7/+oAmQDCf9GAokD8f8xAhIEIf8eAhEEWP8MAngF7P8nAngF2/7+AWoEAADRAmMAxQDhAmoA0ADPAoIAs/t4/SgAAABO/AAAKwBf/FgApv7p/dADaP/L/d0DAf/o/RsEg/69/VwDvv/V/TMEzv4Y/rkEPf/t/acE9v/C/esDzP4v/jEF5f4m/ngF/P+Y/aMDCABV/WcDcwC8AjcDUgC1AlYDd/5nAmAB0QAt/XgAwAAQ/WQA6AAx/QUAgACQ/AUAaQBt/BkAxwEX/rwApAFO/iUCRgDL/fgDdQHj/TUBpAHj/YsA+QBf/foAbwGZ/QkAwgDn/d4D8gDd/YQDPgEt/r0D6wDz/ccDOQCZ/aIDWQBG/U4D1ACL/fMCqgCa/W0DfwBA/RwDbQBv/WYDfgC//cEDngDi/QAEawBtA18AdQCFAwkATwCPA1kAEgC6AwoAZgKFAF8BmgIsAKwAjQIjAQ0AZgLFAA0BMgJ2AZAAAgJ6ASwBTQKYAQsAMgI+AQYBGQHvAcEDjAC+AvwCzQAiArwDawBGAswDxQEsAgkA8QDJAgcAyQH9AYUAcgGoAaYDfABzAn8D8wE7AWUCqwHmASwBwQFbAVQDVwCUAm0DTgFbAskAkQAcAhME7wDsAXIFUwApAiIEWfvy/VkAtfuY/VkAWwB6/F4Asvzg/cgBJALOAIUCIAKBALYDRgIxAIUC/QHlAAAEKgIxAC4EcgAYAm4F5AEDAXgFFQKNAHgFKQHSAXgFpwFdAXgFIACiA1wAOv7j/3gFjAAP/VsARQBE/VcDqAA5/d8ByAAg/WgAJgAn/S4DUQAe/SsDtgAR/WcAaAAg/fUCMwAn/ToD",indices:"AAABAAIAAwABAAAABAAFAAEAAwAEAAEAAwAGAAQABgADAAAAAgABAAUABAAGAAUAAgAFAAAABQAGAAAABwAIAAkACgAIAAcACwAMAA0ADgAPABAABwAJABEAEQAOABAAEgANABMAFAAKAAcADgARAAkABwAVABQAFgAHABEAFQAHABcAFwAHABgAGAAHABYAGQAVABoAGgAVABsAHAAVABkAGwAYAB0AHgAZAB8AGwAVABcAGwAXABgAIAAhACIAIgAhACMAJAAgACUAJQAgACYAIQAnACMAKAApACoAKQArACoALAAtAC4ALwAtACwAMAAxADIAMwA0ACQANQA0ADMANgA3ADgAOQA6ADsANwA6ADgAOgA8ADsAPQA+AD8AQABBAEIAQwBCAEQARQBGAEcASABJAEoAPwBLAEwAQABCAEMAQABDAE0ATgA+AE8AUABBAFEAUABOAEQAUABEAEIAUABCAEEAUABLAE4AUgBQAFEAUgBRAEAAQABRAEEATgBDAEQATQBSAEAASwA/AD4AQwBPAFMAPgA9AFQAPgBUAFMATgBLAD4APwBMAD0AQwBOAE8ATwA+AFMATQBTAFUATQBVAFYATQBDAFMAVwBYAFkAWgBZAFsAWQBcAFsAXQBXAFkAXgBXAF0AMgA8ADoAMgBfADwAMQBfADIAYABhAGIAYgBhAGMAIAAkACEAJAAzACEAMwAnACEAZABlAGYARgBnAEcAaABIAGkASgBJAGkAaQBIAEoAagBrAGwAbQBsAEkAbQBqAGwAbgBvAHAAcQByAHAAcwB0AHUAcgBuAHAAdgB3AHgAdAB5AHoAewBxAHAAfAB5AHQAdwB7AHAAbwB9AH4AbgB6AH0AbgB9AG8AfwB3AHYAcwB8AHQAbwB+AHAAcgCAAG4AgQBzAHUAggB1AIMAewB3AH8AcgBxAHsAgAB6AG4AggCBAHUAhAB7AHYAdACAAHUAdgB7AH8AhQCDAHsAdQCAAHIAgwByAHsAgAB0AHoAgwB1AHIAdgCGAIcAiACJAIoAiwCMAIYAjQCGAIwAjgCPAJAAigCJAI4AfgCJAHAAigCRAIgAkgBwAJMAiQCIAHAAkQCSAJMAlACVAJYAjwCXAJAAkgCYAIsAkQCKAJAAkACXAJkAkACZAJEAkQCaAJIAcACSAHcAiACRAHAAkgCbAHcAkQCTAHAAmQCcAJEAdwCbAHgAmgCRAJ0AmgCeAIwAlwCUAJkAkgCLAJsAlwCfAKAAnQCRAJwAmwCLAHgAkACKAI4AiwCGAHgAeACGAHYAlACXAKAAlACdAJkAjACLAJgAmACaAIwAmgCYAJIAmQCdAJwAjQChAIYAXgCGAKEAhwCGAKIAowCkAKUApgClAKcAqABcAFkApgCjAKUAWwBcAKQAqQCqAKgAXACoAKoAqwCsAK0ArgChAI0ArQCsAK8ArACuAK8ArwCuALAAWACuAKwAsACuAI0AWABXAK4ArgBXAKEAVwBeAKEAsQCyALMAtACxALMAtACzAKkAVAC1AFMAUwC1AFUAtgBNAFYAtgBSAE0AUgC3AFAAuABQALcASwBQALgASwC5AEwAPQC6AFQATAC6AD0ANAC7ACQAuwA1ACQAJAA1ADMAYwC8AGIAvQC8AGMAvgBiAL0AYgC8AL0AWgC/AFkAvwDAAFkAXQC/AFoAWQC/AF0AwQAyADoAwgDBADoAMQDCADcANwDCADoAwwCyALEAsgDEAKkAsgCpALMAqQDEAKoAWwCkAKMAXACqAKQApQCkAKcAxQDGAKcAxQDHAMgAyQDKAMsALgAtAMwAzQAtAC8AzAAtAM0AzgDPADQAKgArANAA0QDSACgA0gApACgA0AArANEAKwDSANEA0wDUANUAzgDTANUAzgDVAM8A1QDJAM8AyQDWAMoA1gDVANQA1QDWAMkAxwDXAMgAxwDKANgA2ADKANYAvQDXAMcAYQDIANcApgDGAMgApwDGAKYAxgDFAMgAYwDXAL0AxwDYAL0AhwDZAHYA2gDZANsA3ACEAN0AhQCEANwA2wDZAKIA2QCHAKIA3gDaANsAewCEAIUAhADeAN0AhAB2ANoAhADaAN4A2QDaAHYAYADdAN4A3QBiANwA3ABiAN8AYABiAN0AYgC+AN8A4AAzACQA4QDiAOMA3wDhANwA3ADhAOMAhQDcAOMA5ACBAIIA5QDiAOYA5QDkAIIAgQDkAHMA4wDiAOUA4wDlAIIA4wCCAIMA5QDmAOQAhQDjAIMA5gDnAOQAbQDoAGoAagDoAGsAawDoAGwAjACwAI0AbQCUAJYAlABtAGgAmgDpAJ4AsACeAOkAsADpAK8AjACeALAA6QCdAJQAmgCdAOkA6gB+AH0A6wDsAO0A7gDvAPAA8QDyAOwA8wDwAPQA9QDsAOsA9gB9AHoA9wD4APkAeQD2AHoA8QDzAPQA7wD6APAA8AD6APcA7AD7APEA/ADqAH0A7QD9AHkA8wDuAPAA8AD3APQA+QDqAPwA/AB9APYA9AD3APkA+wDzAPEA8gD9AO0A/QD8APYA7ADyAO0A/QD5APwA8QD0AP0AfABzAP4A6gCJAH4A+ADqAPkA7QB5AHwA/QD2AHkA8QD9APIA9AD5AP0A/wAAAQEBAgGfAAMBoACVAJQA6gD4AIkABAEFAQYBBAEGAQMBBwH4APcACAEJAY4ABgH/AAEB9wD6AAcBBwH6AAoBlQCgAJ8ACwEIAQcBjwCfAJcACAEEAQkBBAEDAQkBCAELAQQBCwEFAQQBCgEFAQsB7wAKAfoADAECAQEBnwAMAZUAnwACAQwBiQAIAY4A+AAHAYkACAGJAAcBjgAJAY8ABQH/AAYBAwEGAQIBBgEBAQIBCQGfAI8AAwGfAAkBCgELAQcBDAEBAQ0BDgEBAQABAQEOAQ0BDwEQAREBEgETARABEgEUARMBDwGVABIBlQAUARIBFAEOARUBlgCVAA8BEwEUARYBEAEPARIBDAEUAZUAFAEMARcBFgEUARUBFAEXAQ4BFwEMAQ0BDQEOARcBGAGrABkBqwCtABkBGQGtABoBrQCvABoBqwAYATcAqwA3ADYAqwA2AC8AOwDMADkALwA2AM0AtACpADwAPACpADsAOwCpAC4AOwAuAMwAOgA5AMwAqwCpAKwAOAA6AMwAOADMAM0AhgBeAF0ALAAuAKkAtAA8AF8AogBdAKMAogCGAF0ALACpAKsAXQBaAFsAWACoAFkAogCjAKYANgA4AM0AXQBbAKMALwAsAKsArACoAFgArACpAKgAGAExADcAGAG0AF8AGAFfADEAwwCxALQAwgBVAC0AugBMAKcAMQBVAMIATAC5AKcApwC5AMUAqgC/AKQAtwA1ACsAqgDAAL8AYgBLAMoAxQC8AMcAKwA1ANIANQC7ANIAUgA1ALcAuQBiAMUAxQBiALwAxABZAKoAqgBZAMAA0gC7ACkAsgDDAC0AUgA0ADUAwwAyAC0AMQBWAFUAwwBWADEApAC/AKcAMgDBAC0AvwBZAKcAywDPAMkAKQA0AM8AuwA0ACkASwDPAMoAygDPAMsAwQDCAC0ASwAbAc8AtgAcAVIAUgAcATQAuAAbAUsAwwAcAbYAwwC2AFYAuAC3ACsAVQC1AC0AxABUAFkAYgDHALwAsgBUAMQAVAC6AFkAsgC1AFQAKwApABsBuAArABsBuQBLAGIAsgAtALUAwwAwADIAGwEpAM8AYgDKAMcAwwAxADAAWQC6AKcAHAHOADQAHQHOABwBHgEfASABHgEhAR8BIgEMAAsAIQEeAXwAIwEeASABJAEgASIBfAAeAesAJAEiAQsAIwHrAB4BHwElASIB7QB8AOsAIwEgASQB9QDrACMB+wD1ACYB+wAmAScBJwEkAQsAIAEfASIBJwEjASQB9QD7AOwAJwEmASMBIwEmAfUAKAH+ACkBIQEoASUBKAEhAf4AfAD+ACEBJQEfASEBSQBIAG0AKgERASsBLAFsAOgAKgEsAREBGgEsASoBGgFsACwBGgGvAGwA6ABtAJYAaADpAJQA6ACWAA8BLAHoAA8BaACvAOkAaQCvAGgALAEPAREBSQCvAGkAbACvAEkAbQBIAGgALQEuAS8BLwEuATABMQEdARwBMgEWADMBJQEMACIBNAEMACUBGAAWADIBNQE2ATIBNQE3ATYBOAEdADYBOAE2ATcBNwEtAS8BEwANADkBOgE7ATwBPQElASgBEAA7AToBPAETADkBNQERABAAPgE9ASkBNQEQAD8BOgFAAUEBQQFCAT4BQgE9AT4BOgE8ATkBNQEyATMBNwE/AUEBQwFAATkBQwENAAwANAFDAQwAQwFEAQ0ANwE1AT8BMgEdABgAMgE2AR0APQFDATQBPQE0ASUBRAE5AQ0AOQFEAUMBPAE7ARMAPQEoASkBQwE9AUIBQwFCAUABQAE6ATkBPwE6AUEBQQEtATcBDwATADsBOAE3AS8BMwEWABEAMwERADUBPwEQADoBEAAPADsBQQFAAUIBRQFGAUcBSAHDALQASQEcAEoBSgEcABkASwFMAR8ATQFOAUsBHgBKARkATwFNAUsBSwFQAUwBHwBMAR4AHgBJAUoBTgFQAUsBHgBMAUkBUQFSAVMBEwFUARABVQFWAVcBUQFYAVIBWQFUAVMBWgFbAVwBUwFSAVkBEAFUAREBWQEqAV0BXQEqASsBWQFSASoBXAFbAVgBWAFeAVIBWgFOAVsBWAFbAV4BVAFfAVMBVwFbAU4BXgFWAVIBTwFXAU0BVwFeAVsBTwFVAVcBVwFWAV4BXwFRAVMBTQFXAU4BYAFYAVEBEQFZAV0BVAFZAREBYQFUARMBEQFdASsBXwFUAWEB4AAkANMAYgHhANYAKgBiAWMBogCmAMgA2wCiAMgA3gDbAMgALgFiAScAJwBiASMAIwBiAdAALgEnADMA3gDIAGEA1ADTACgA0wAkACgA1ABiAdYA0ABiASoAIgDQANEAIAAiANEAYwBhANcAGwFjAWIBGwFiAdQAKAAbAdQAKAAqABsBJgAgANEAJgDRACgA1gC9ANgA3gBhAGAA4QDfAL4AJQAmACgA4QC+AL0AIgAjANAA4QC9ANYALgEzAOAAKgBjARsBZAEuAeAAJAAlACgARwBlAeIA/gBlAGQALQFFAEcALQFHAOIAQQFFAC0BKQH+AGQA/gBzAGUBQQFkAEUAZwBlAUcAQQEpAWQAPgEpAUEBZQBlAWcAZQD+AGUBZQHnAOYAZQBnAEYA5wBzAOQAZQHmAOIAZQFzAOcAZgBlAEYAZABGAEUAZABmAEYAGAFFAbQAGQFFARgBWgFmAUwBTAFQAVoBHABnAWgBHABoARUASQFmARwAHABmAWcBTgFaAVABTAFmAUkBWgFcAWkBFQBoARQAaAFqARQAFABqAQoAYQFrAV8BYQETAWsBaQFsAW0BWAFuAW8BZgFaAWkBbwFsAWkBZgFpAWcBCgBqAQgAZwFqAWgBWAFgAW4BFgFrARMBaQFtAWcBXAFYAW8BXAFvAWkBagFtAQgAUQFfAWsBUQFrAWABZwFtAWoBHQBPAUsBHQBLARsARgHDAEgBHQBVAU8BVgHDAEYBGgAfABkAGwAfABoAGwBLAR8ALwEcAcMALwHDAFYBOAEvAVYBMAEcAS8BOAFWAVUBMAExARwBHQA4AVUB4gDhAC0BLQFiAS4B4QBiAS0BMAEuAWQBMAFkATEBHQHTAM4AHQExAWQBZAHgANMAHQFkAdMAtABwAUgBSAFHAUYBGQFWAUYBtABHAXABcAFHAUgBtABFAUcBGQFGAUUBVgEaASoBVgEqAVIBGQEaAVYBcQEVAQ4BcQEWARUBDgAJAHEBEgBxAQ0AawEWAXEBDwAOAHEBEwAPAHEBEwBxARIAYAFrAXEBbgFgAXEB7gBxAe8A8wBxAe4A+wBxAfMAbwFuAXEBJwFxAfsAbAFvAXEBCwBxAScBcQEFAQoBbQFsAXEBcQEKAe8ACABtAXEBcQH/AAUBDQBxAQsACQAIAHEBcQEAAf8AcQEOAQABcgFzAXQBdQFyAXQBdgFyAXcBeAF5AXIBcgF5AXcBegF2AXcBdQF4AXIBdAF5AXgBdQF0AXgBcwF5AXQBdwF5AXMBcwF2AXoBcwF6AXcBcgF2AXMB",count:770},{rgb:[.902,.922,.929],positions:"JP/G/QEBFP+Z/SkBYP+//VYBIv/F/Y4BTP81/WUBNf9L/QsBZf9j/TUBUP8c/VMBIv8Z/QYB8f4f/QMBEP87/ZQBNP8R/X8BOf8D/TABEP8K/YsBP/8C/VcBJf8F/RgB3P5o/VgBOv9Z/VcBv/4X/U0B+v4N/YkB8P4P/RAB+v5j/SMBPf+5/QAB4P7O/SIBaf+1/YEBV/+j/RkBBP+1/f8A2P69/TsB4P6k/RQBUf+O/RAB3v7E/W4B8v7M/YgB9P7B/YwBU/+M/X0BYv93/UsBWf+n/XwBDv99/ZYB6/6v/YkB4/6c/YoBIP+v/ZwBXv+u/WoBFv/L/YABX/++/RsBCf+I/f4APP9f/QEBHf90/e8AwP58/RkBAv97/fcAvf55/XMB+v5u/Z8Bxv6E/XMB0/4Y/X0Bvv4y/UkBzP41/R0B3f47/YEB0f5v/R4BHf9s/aUBRP9s/ZABYv9o/W8B1/5//RkB1P6M/VsB/v50/QwB5v7U/VcB+P6d/XQBX/04AiABX/04AsQBa/06ApcB8P1PAiABff2U/U0CjP2t/U0Cbf3Q/U4CAv3h/d8BDv2b/QACiP2Q/VsC7/2l/QECpv3H/U8C6/3O/bkB4v29/ZsBk/2i/W8Bkf3d/XUBTP3o/YkBIP3v/c0BIv3v/fYBOv3r/SgCcv3i/UUCwf3V/TkC2P14/aEBl/2B/W0BYv2K/U4C0/1m/SkC6f1z/e0BOf2D/UMCKP2W/Y0BFv2R/agBvf1R/aQB0/3y/PMBsv1R/RsClf0Y/UcCgv1a/TECBv0k/SsC9fwW/eUBXP0F/UkCzP0A/Z0BXf1i/S8CH/1r/e8Bbf0U/VcCIf15/ZIBcP1q/WwBKf0X/X0B4/1W/Z0BC/19/QMCB/2I/d0Bzf1i/YcBMf1x/T0CbP1r/VECof1n/UoCVv1i/YsBa/38/SYCPv0D/tABMf1s/bAByP1T/QEC0v3r/dYBlf31/TMCe/35/ZABSv9j/WcCOf9T/ZICQf9S/XMCI/9i/acCxf4l/W0CEv8O/TYC5P57/VICIv9g/UYC8v5s/aECOf8J/YMCDf8O/bECM/8E/U4C3v4c/bQC1/4S/UcCGP8I/bUCDf9W/U4CM/9R/VkC+f5d/UkCBP9X/aICGP9U/ZsCMP9Q/YgC3/5h/YkC7v5b/WsC9P5b/ZEC4v5h/V4CRP8B/X8CzP4t/UECQf8g/aQCxv4z/ZcCSP8d/VMCHf8v/bkC5/4v/TQCNP+Y/UgCHv+X/TwC7v6f/U8CSP+T/X8CT/+P/Y8CZv+h/X8CX/+h/VICZv+8/WYCL/++/cECVP+5/awCF//M/b8C6P6X/bQCPf+K/bsCGP+l/cUC5f7R/UIC9P6//TkC1v65/Y4CEP/J/SMCV/+o/aYCNv+o/cACHf+Z/agC+f6m/ZgC5v7E/Z8C6P6h/X8CNv+W/ZwCKf+p/SYCUP9m/ZcCN/9q/TUCXf+G/ZoCHP9v/ckCQv+L/TUC4/65/TsCUP+2/T0C7f6v/T8CZ/9r/VcCH/91/RoCy/58/VEC+/5//SUC8/5q/b4C0P5//a0CWP9m/agC7/52/TMCyf5y/XQCTv9b/TwC5/6a/TUC0v6f/WEC8P48/b4CP/86/aQCTv8w/W4C+P67/b4C9/7C/bIC8/6s/YgC9v6r/VgCN/+j/Z8CFf+t/aUC7/61/WUCIP+w/UkCFv+h/UcCSP+q/WwCJf+v/aIC9f63/YICNv+nAl0BSv+dAnwBKv+lAjoB7v6cApoBHf+ZAqoBCP+kAqUB2P6OAl4BI/+kAkQB3P6bAmEBAv+iAkEB4P6lAmIB6v6oAoAB9/6qAlcB+P6qApoBEP+uApgB9v6qAkcBFv+vAkwB1v7tAqABPv/+AncBF//4AqcBxP7rAmkBOP/9ApQBRv/sAooBxf7qAoYBO/+TAk0BLf+yApUBPv+0AnMBN/+0Al4BLv+zAmQBKf+yApABP/+pAocBBP/1AjIBNP/9AkkB4v7wAjwBB//UAikB1P6+AkQBwv7KAnEBxf7LAo4B/f7WArkBBf/pAsEBLv/bAq0BMP/QAjYB1P6cAqEBzf6SAlMBKv+qAicBS//DAl0BcP+mAncBOv+sAq0BAv+oArkB6v7IAjIBUf+3AoUBwf5+AmEBwf6IAkIBKf+eAh4B3P6SArkBEP+RAhMBKf+eAskBXf+SAqQBCf+FAs0BIf+OAr4Bzf59AqAB6v6KAq4BTP+ZApoBzv6FAlwBT/+aAk8BYP+ZAj4Bvf6KApEB5f5+Ai0BMv+AAjwB7P6KAjQBJv+TAiwBBP95AjMB2P5yAmAB7P51AkABUv+GAnQBF/+GAiMBF/98ArAB2/5yAo0B",indices:"AAABAAIAAQADAAIABAAFAAYABAAHAAUACAAJAAUABwAEAAoACwAHAAoABwAIAAUABwAMAAgADQALAAoABwAOAAwACAAMAA8ABwALAA4AEAARABIAEgARABMAFAAVABIAFQAQABIAAAAWABcAGAAZABYAFgAaABcAGgAWABkAFwAaABsAGgAcABsAHQAaABkAHgAfABcAHwAeACAAIQAiACMAJAAhACMAJAAjACUAJgAkACUAJQAjACcAJwAjACgAHgAlACcAJwAYACAAHgAnACAAAwAgABgAKAAYACcAIAADAB8AHwADACkAKAAZABgAIgAZACMAIgAdABkAGAAWACoAIwAZACgAGgArABwAGgAdACsALAAtAAYALQAsAAUALQAFAC4ALQAuAC8AMAAxADIADAARAA8AEwARAA4AEQAVAA8ADwAVABQADgARAAwADgANABMAEwAzABIAEgAzADQADgALAA0AFAASAAkACAAUAAkACAAPABQADQAzABMAMwANAAoAEgA0ADUACQASADUAMwAKADQACgA2ADQANQA3AAUACQA1AAUANwA1ADQANgAKADgANgA4ADEANAA2ADEANAAxADcALAAGAAUANwAxADAANwAwAC4ACgA5ADgABAA5AAoAOgA5AAQALgAFADcABgA6AAQAOwAvAC4AMgA7AC4AMgAuADAABgAtACIAMQAkADIAOAAkADEAOQAkADgAOgAkADkAOgAiACQAPAA7ADIAPQAvADsAKwAvAD0AKwAtAC8AJAA8ADIAIgAtACsAOgAGACIAOwA8ABwAJAAmADwAOwAcACsAPQA7ACsAIQAkACIAHQAiACsAFwAfAD4AGwAeABcAHAA8ABsAGwAmACUAPAAmABsAGwAlAB4AGAACAAMAAAAqABYAAgAqAAAAKQA+AB8AGAAqAAIAFwABAAAAKQA/AD4APwABAD4APgABABcAQABBAEIAQQBDAEIARABFAEYARwBIAEkARgBHAEkASgBLAEkATABKAE0ATABNAE4ATwBMAE4AUABPAE4AUABOAEcAUQBQAEcAUgBRAEcAUwBSAEcAVABTAEcAVABHAEYAVABGAEsAVQBUAEsAVQBLAEoATABVAEoATgBWAFcASQBIAFgASQBYAFkASQBZAFoASgBJAFoAWwBYAEgASABcAF0AXgBfAGAAXwBhAGAAYABhAGIAYwBkAGUAYwBlAGEAZgBhAF8AYQBkAGcAZQBkAGEAZwBkAGgAaQBjAGEAagBrAGwAawBtAGYAawBmAGwAagBsAGMAYwBuAGoAbwBqAG4AbQBrAHAAcQBbAG4AcgBbAHEAWQBwAFoAcwByAGkAcQBuAGMAcwBpAGEAWQBzAGEAcQBjAGkAcgBxAGkAWQBhAGYAWQBtAHAAWQBmAG0AYwBsAGQAaABkAHQAbABmAHQAdABmAF4AZABsAHQAZgBfAF4AZwBoAHUAdQBoAHYAYgBnAHUAYgBhAGcAaAB0AHcAXgBgAHgAYABiAHgAeQB4AHoAeABiAHoAaAB3AHYAewBeAHkAdwB0AHYAdgB0AHsAdABeAHsAXgB4AHkASABvAG4AWwBIAG4AWABbAHIAWAByAHMAWQBYAHMAYgB1AHoAVgBaAHAAVwBWAHAAXABwAGsAXABXAHAAXABrAGoAXQBcAGoASABdAGoASABqAG8ARgBJAEQARABJAEUARgBFAEsATQBKAFoATQBaAFYATQBWAE4ARwBOAFcARwBXAFwARwBcAEgASQBLAEUAfAB9AH4AfAB/AH0AgACBAIIAggCBAIMAggCEAIAAhQCGAHwAfACGAH8AfwCGAIQAhQB8AIcAhwB8AIEAfACDAIEAhACIAIAAiQCBAIAAigCIAIYAiACEAIYAgwB8AIsAfAB+AIwAgwCLAI0AfwCOAI8AfgCLAIwAjACLAHwAfQCLAH4AfQCQAIsAfwCPAH0AfQCPAJAAkQCSAJMAlACSAJEAkgCUAIsAiwCUAI0AkQCTAI4AhACRAI4AjgCTAI8AlQCFAIcAigCFAJUAhQCKAIYAlgCBAIkAlgCJAIAAigCXAIgAgACYAJYAgACIAJgAhACCAJEAggCDAI0AggCNAJQAfwCEAI4AggCUAJEAmQCVAIcAgQCZAIcAlwCKAJUAmQCXAJUAlwCaAIgAmwCBAJYAnACdAJ4AnwCgAJwAoQCiAKMApAClAKYApwCoAKkAqgCrAKwAowCtAKoAoQCuAK8AqgCcAKMAnACgAKMAowCgAKUApQCgAKYAoACwAKYAsACxAKYApgCxALIAsQCzALIAsgCeAKoAswCeALIAtACwAJ8AngCdAKoAnQCcAKoAqwCqAK0AtQCrAK0AtgC3ALgAtgC4AKgAuQC2AKgAtwC6ALgAqwC7AKwAtQC7AKsAogC1ALwAowCiALwAuwC9AKwAuwC1AL0AnwCwAKAAowC8AK0AuAChAK8AqAC4AK8AqACvAKkAvgC3ALYAvwDAAMEAwgC5AMMAvwDBALcAuQDEALYAvgC/ALcAtgDEAL4AtwDBAMUAwQDAAMUAxgDCAMMAxAC5AMIAvwDHAMAAtQCtALwAugChALgAtQC6AMgAyADJAL0AwADDAKcAtwDIALoAtwDFAMgAwACnAMkAuQCoAKcAwwC5AKcAwADJAMgAxQDAAMgAvQDJAKwAogC6ALUAvQC1AMgAogChALoArACnAKkAyQCnAKwAmwDAAMcAygDCAMYAwACYAMYAmADKAMYAgQCbAMcAmQCBAMcAlwDLAMoAzACZAMcAmQDMAJcAiACaAMoAlgCYAMAAlgDAAJsAmACIAMoAmgCXAMoAzQCpAK8AzQCsAKkApQCvAK4ApgDOAKQAlwDMAMcAywCXAMcAywDHAMQAygDLAMQAygDEAMIAsgDOAKYAzgCsAM0AsgCsAM4AsgCqAKwApQCkAK8ApADNAK8AowCuAKEApADOAM0ApQCuAKMAvgDHAL8AzwDQALMAzwCxANEA0gDPANEA0wDQAM8A1ACcANUA1ADWAJwA1ADVANAA1gDRAJwA0wDUANAAnADRAJ8A1gDXANEA2ADPANIA2ADUANMA2ADSANcA2ADTAM8A0ADVAJwAsQDPALMAsQCwANEA0QCwALQA0QC0AJ8AxADHAL4A0ACcAJ4A0ACeALMAxgDDAMAA0QDXANIA2QDaANsA3ADdAN4A3wDgANsA3QDaANkA4QDgANwA4ADhAOIA4wDhAOQA4wDkAOUA5gDeAOcA4QDjAOgA3ADeAOYA6ADiAOEA5QDoAOMA5ADmAOcA5ADcAOYA5ADhANwA5QDpAOgA2QDbAOAA3QDZAN4A3ADgAN8A3QDcAOoA6wDaAOwA2gDdAOwA3ADfAOoA6gDfAO0A7ADdAOoA6wDuAO8A7ADuAOsA8ADqAO0A2gDxANsA5wDeAPIA8wD0APUA6QDiAOgA6QDgAOIA9gDzAPUA8gD3APMA8gDzAPYA9ADgAOkA9QD0AOkA9ADZAOAA8gDeAPcA8wDZAPQA8wD3ANkA5wDyAPYA+ADbAPkA7QDfAPoA2wDxAPkA8QDaAPkA+QDaAOsA3wDbAPoA+gDbAPgA+QD7APgA/ADtAPoA7wD5AOsA/QD+AO0A/wDvAAABAQHvAP8A/QDtAPwAAgH7APkA+wD6APgAAwH+AAQBBQEEAfwABgEHAQUBCAEBAQkBBAH9APwABQECAQYBBQH8AAoBCwEGAe8ABQEKAQIB+wACAQoBCgH8APoA+wAKAfoABgECAfkABgH5AO8ADAEDAQ0BBQEHAQ4BDwEJAQMBCwEHAQYBBQEOARABCwEIAQcBBAEFARABDQEEARABEQEIAQkBDQEDAQQBDwERAQkBEgETARQBEwEPARUBBwERARIBEgERARMBFAETARYBEgEUARcBEwEVARYBFQEMARgBEgEZARoBEgEXARkBFQEbAQwBDQEQARwBEAEOARoBGgEOAQcBBwESARoBFQEPARsBEQEHAQgBEwERAQ8BHQEeAR8BHQEgAR4BIQEVARgBIQEYAR4BHQEfARkBIgEhAR4BIwEdARkBIAEiAR4BEAEaASQBEAEkARwBDAENARwBJQEUARYBIQEmARUBIwEZARcBIwEXARQBJgElARYBJQEjARQBJgEWARUBHgEcAR8BHAEkAR8BJAEaAR8BDAEcARgBGAEcAR4BHwEaARkBBAH+AP0AGwEPAQMBGwEDAQwBCwHvAAgBAwEJAf8A/gADAf8A/gD/AAABCAHvAAEBCQEBAf8AAAHsAOoAAAHvAO4AAAHuAOwA/gAAAeoA/gDqAPAA/gDwAO0A3gDZAPcA",count:542},{rgb:[.251,.251,.251],positions:"Lv9V/VoBCv8B/W8BJP/8/FoBFf8A/SwBAP9c/TUB4f4J/TwB3v4I/WQB8P4F/ScB9P4F/WMBB/9b/XABmv0+AugB+f1OAsEBX/01AtAB8f1NAhQBt/1DAvwAS/0yAkcBHf5UAmcBAP8I/ZsC6v4M/XUCGv8E/XwCAP8O/XoCDv8G/VYC5v4P/VoCHv9T/W8C+f5Z/ZgC8v45/Y0C7f7xApcBBP/qAowBAP/2AoMB6v70AlcB2/7vAmcBG//6ApEB9f7qAmoBEf/vAmoB/P6rAmkBCP/4AksBMv+zAmUBJf/8AmQBKf+yAo8B",indices:"AAABAAIAAAACAAMABAAFAAYABAAAAAMABAADAAcABAAHAAUAAwAFAAcAAQAFAAMACAAGAAUAAQAIAAUAAQADAAIACQAGAAgACQAIAAAACAABAAAACQAEAAYACgALAAwADAANAA4ADAAOAA8ADQAMABAAEAAMAAsAEQASABMAEwAUABUAEgAUABMAFQAUABIAFgAVABIAFwARABMAFwATABUAFwAYABEAEgARABkAFwAVABYAFwAWABIAGQAXABIAGAAZABEAGgAbABwAGgAdAB4AHwAbABoAGgAcACAAHAAfACEAIgAeAB0AIgAdACMAJAAjACUAJAAiACMAJAAlAB8AJgAkAB8AIgAaAB4AIgAmAB8AIgAfABoAHwAlACEAHQAaACAAJQAgACEAHQAgACMAIwAgACUAIQAgABwAHAAbAB8A",count:54}],link1:[{rgb:[1,1,1],positions:"DgL5/17/JgLp/wEAGAJ6/3P/dAC8/9X9LADU/9b9ogD5//L9lf/4/+b9DQCu/7X9GwH4/yj+3AGN/9H+7QE3/77+qQH5/6P+6gH5/wj/KQHG/yf+ZgGa/zv+sQF8/3L+WwGN/xn++ACZ/9X9XwCi/3/9iACm/8D97ACu//f9cgG+/13+pgCf/7f9DwGl/wL+xQC///H9BwF//eQBgwGG/YgBIwH5/+4BJgIAAID4CwKwAID4JwIOAKn4Ef+Z/8n9hv+i/6790f6Q/7D9tf/N/9f98v35/17/3P13/8j/2P36/+D/5/1o/3f/Ef+j/+r9s/+2/8v99/63/w7+K//z/wb+b/+6/9z9l/75/2H+sP6t/zr+P/6O/6H+Kf75/+L+A/59/xf/mf6L/yL+9v75/xz+3P1w/zQAb//5/xMCzP9w/yQCzP/5/yQCzP9w/yQCNAD5/yQCm/9l/RwC7f35/5EA4P3i/+X72v26/9T79f1i/7D8av+y/y79IP4z/4n+JP8IAML87v/Y/wf9/f+7/zP9T/5d/0r+Ev7u/jb+O/45/xr+Kv4n/+P93P0o/ub+2/0d/pr+2v2q/QEA3f0+/mn//f39/oD9A/58/5382/1b/vH9K/67/5b8Pf6A/xL9ff5z/+T9Vv5j/6b9hP6R/0n9if6x/wL9cP7p/6b8U/4LAGz8pP4bAIv8Hv4SADj8/f0bAAD8+P1uAMn76f5nAHD8X/82AK38sf8zATz8AP8gAR/8AAALANf81f8NAm77nP8eAgj7G//qAUD7n//OAcL7HwDeAb77/P+bAf77b/96AQP8sv5oAcD7pv4iAe/7hv5hAEn8Bv7cAEj7A/60AJT7QP4ZAZD74P1PAIz7Q/48AU/7Nf7hAMP7cf7kAPT7Pf+6Aa37Wf8NAgb7Fv/zAQf7l/6fASf79/8lAhP7UAC2AeX7agASAjn72AH+AIb7EQJnALP7CAK2AEr7swFkACn8ugEBAG38AAIHABX8TAD1AF38cQAVAMf8xgAiALD8AgHr/9L8XAEsAHv8twAHAgv7CgHeASb77wCrAav7rABGASL8ZQEQAfb77ABeAfj7xwH5ALP7JAIfAKb7agDgAaP7zwEmAT/7mwFuASL7egFKAbP7bQFvAZj7QgG+AQz7JAIH/l3/WgGG/+n9HAGb/1T9egG+/9/84wG1/5T8sAG4/8j8GQKH/1X8igF//2v9PAGu/x79uQFR/0D+DALC/uP+5wES/2v+GQJm/lP+JQIf/n/+JwK//eL/IwKG/rn9JAJa/t79sgFn/3L95AFt/wf97AHz/if+zAE+/7b9GAL5/50AIAKi/VIAzgGI/SsBBAKH/bsAyQB8/QACRAB8/SIC+v9//SYC0/52/c0BNP97/f8B5/75/9oBf/58/YgBY/75/20BTP5p/UwBD/75/+oABf55/dMA4f2S/V0ATv/c+7QB3/+5+8MBuP/N+8kBbf/D+7QBUf7N+6sAmv6h++kAg/7Q+wsBAADO+88B+f7I+4j+PP+s+3X+Gf+O+6/+Qv7N+4P/NP7I++P/MP7q+6//t/5b/Fv+ov7D+9r+wgDL+6YB7QCD+0EBNAHO+1sBRQDO+8sBigCi+5cBlgDP+7cBuAHJ+48AmQHO+90AngGa+1sAXgG9+x4BtP/2+v7/GAD1+sD/MQDy+gkAzgHM+xsAjAGF++r/zQHW+7j/wAHY+3j/owG++0r/aQHM+9/+FgFQ+zz/MgHH+6j+bwBe+63++ADL+3v+nwDK+07+8P+q+0v+1v8y/OD9oP+s+1L+7/5M+zX/bf7I+yH/t/5T+7P/EwE3+63/mQA5+w3/oP89++f+2QAZ+/r/nAAG++3/dQAH+4//JAAG+2P/0P8H+2X/iP8G+5X/ZP8F+xMArP/6+jsADAD2+kEANwFK+x8A7f41+yIAm/5s+18ANv7Q+1IAwv7J+1AB9P7R+3wBRP9X+yMB4/9a+1sBNwGB+/EAQAAl+/AA/gAx+3QAZP8O+3MAwgAq+6YAwgAY+1cAzP8H+5oAMgAG+5cA2QGv/MQAnwFe/WQBRgCp/P8B8AFu/NX/DQBa/Wn8OAAE/QP9yP9h/WT8EwBt/LP9AAAG/Aj+8wDC/Lv9sgFj/Pb+JAKn/Zz/6gFP/b/+AACg/Z77YACH/RT8OgHG/Vb83QAI/Ur9ZQBs/MT9LgGH/dT8iAFx/YT9XgGp/Db+zQGx/P3+iwH6/Cf+uwEs/U/+IQLe/tb8JgLO/8X76wHz/k/7DQJT/yb7wP+6/T77UADE/fz6hQDI/Tb7XQFB/gL7mQF6/iH7DgH7/VX7sQE4/mb8wQGx/Z79JQL2/6j4DQJS/4D4ZwFf/oD4dwFp/qH5HwEs/oD4YQAdAgT7RwAkAoD4zwD/AYD4zv8lAoD4LAHNAYD4swFTAYD4BQDX/a75NQDc/YD4nwD1/YH42wHi/vf5zAHT/oD4ywAG/oH4cQGZAYD4if/j/aP5CP4h/xL5Cf4i/4D4MP7X/oD4Rf5OAYD4Ff78AID4xv7DAQX7FP/+/Zf61f40/oD4qP5S/pj53f3F/yv74v2V/4D4Af4h/2P72v0eAID4TP6X/kP7Gv7i/nL7if5x/oL4Nv7Q/qz49P7t/bz7Zv52/kf7Ov/S/Xv7av/R/RP78v2gAIH4Gf46/N7/wf8T/e/88f3s/mD8/P1T/Sr/kf+z/Y37Wv8i/QP9Xv6H/Ln+tP5V/U/97/73/JD9Sf9r/OD9nf+Y/JT96f3s/XH+O/5F/Db/3P6A/dT8Xf7+/FT+F/6X/l/8bv+g/ff7d/79/Z38rP7j/Vb8Mf+j/Sr8Vv5l/uH7P/4g/tf8Kv7B/bv9M/4e/ZX+0/+r/P8Bp/6l/HkBPP6s/PEAFv6y/JUACP6U/DIAev/o/YD4Bv/vAYD4fv6JAYD4hP8YAoD4HAIKAKj4",indices:"AAABAAIAAwAEAAUABQAEAAYABwAEAAMABQAIAAMAAAACAAkAAgAKAAkACwAMAAkACQAMAAAACwANAAgADgAJAA8AEAARAA4AEgAHABMABwADABMAFAAVABYAFgAVABcAEwAUABYAFQAOABcADQAYAAgAGAADAAgAAwAYABMAGAANABMAEwANABQAFAANABUADgARABcAFwARABYADQALABUACwAJABUAFQAJAA4ADgAPABAAGQAaABsAHAAdAB4AHwAgACEABwASACAAIgAEAAcABgAEACIAIwAkACUAJgAkACMAIAAfACcABwAgACgAJwAoACAAKQAqACsALAApAC0ALQAuAC8ALwAuACMALgAwACMAKgAoACsAHwAxACcAJwAxAC0AMQAuAC0ALQApACcAKQArACcAKwAoACcAJgAjADAALwAsAC0ALAAyACkAKQAyACoAKgAGACgAKAAGACIAIgAHACgAMwAlACQANAA1ADYANgA3ADgANAA5ADUAMwA6ACUAOwA8AD0AIAASAD4AIQAxAB8ALgA/ADAAIAA+ACEAQAA+AEEAQQA+AEIAPgASAEIALgAxAEMARABFAEYAQwBFAD8ARQBEAD8APwBEAEcARwBEAEgAPwAuAEMARwBJAEoASgBJACQAMAA/ACYAPwBHACYARwBKACYAJgBKACQAPABLAD0ATAA7AD0APABNAEsASwBMAD0ATgBMAE8AUAAhAFEAIQBSAFEARgBLAEQASwBGAEwARgBRAEwATABRAE8AUQBSAE8AUgBTAE8ATwBTAE4AUwBUAE4AVABVAE4AQABUAD4AVABTAD4AUwBSAD4APgBSACEAIQBQADEAMQBQAEMAUABRAEMAQwBRAEUARQBRAEYARABLAEgASwBNAEgAVABAAFYAVgBVAFQATgBXAEwAVwBYAEwATABYADsAOwBYAFkATgBVAFcAWgBWAFsAWwBWAEAAWwBcAFoAWgBcAF0AXABbAF4AXwBgAGEAXwBiAGMAYwBiAGQAYgBlAGQAZABlAFwAQABBAFsAQQBeAFsAXABlAF0AZQBmAF0AZgBnAF0AXQBoAFoAWgBoAFYAaQBqAGsAagBsAFkAbQBpAGsAagBuAGsAWABXAFkAWQBXAG4AVwBvAG4AbgBmAGsAZgBwAGEAYQBxAHIAOwBZAGwAagBZAG4AawBmAG0AbQBmAHMAZgBhAHMAYQByAHMAVgBoAFUAVQBoAFcAVwBoAG8AaABdAG8AbwBdAG4AXQBnAG4AbgBnAGYAZQBiAGYAZgBiAHAAcABiAGEAYQBiAF8AXwB0AGAAdQBkAFwAdABfAHYAdwB4AHkAegB7AHwAXABeAH0AfQBeAH4AfwCAAIEAggB2AIMAgwB2AIQAfwCFAH4AfgCFAH0AfQCFAFwAXACFAHUAewB6AIEAgQB6AIYAgQCGAH8AfwCGAIUAZAB1AGMAhwCFAIYAegB8AIgAdwCIAHgAiAB8AHgAfACJAHgAXwBjAHYAdgBjAIoAiwCMAHcAdwCMAIgAiACMAI0AjACOAI0AjwCDAIwAjACDAI4AjgCDAIQAdQCEAIoAhAB2AIoAYwB1AIoAdQCFAIQAhQCHAIQAhwCGAIQAhACGAI4AjgCGAI0AhgB6AI0AjQB6AIgAAgABAJAADwAJAAoAEQAQAJEAEQCSABYAEwAWABIAfgBeAEEAgAB/AH4AkwCBAIAAlAB7AJUAlQB7AIEAlACWAHwAfgBBAJIAFgCSABIAkQCXAJIAkQCSABEAEgCSAEIAmACSAJcAmQAPAAoACgACAJoAmgACAJAAEAAPAJEADwCZAJEACgCbAJkAnACaAJ0AnACbAJoAAQCeAJAAkACdAJoAnACfAJQAlACfAJYAnwCgAJYAfACWAIkAfAB7AJQAQgCSAEEAoQCXAJsAlwCRAJsAmwCRAJkAlQCBAJMAlQCiAJQAlACiAJwAmwCcAKMAowCcAKIAowCiAKQApACiAKEAogCVAKEAoQCVAJMAmACTAIAACgCaAJsAowCkAJsAmwCkAKEAoQCTAJcAlwCTAJgAmACAAJIAkgCAAH4AngABAKUAngClAKYApwCoAKUAqACmAKUApQAbAKcAGgCnABsAGwCpABkAqQAbAKoAOACrABsAqwCqABsAOQCrADcANwCrADgArACtAK4ArgCtADQArwCsALAAsACsAK4AsACxAK8AsgCzALAAsACzALEAtACzADoAOgCzALIAJAC0ADMAMwC0ADoAJABJALQAtQC2ALcAtQC4ALYAuQC6ALsAvAC3ALYAvQC+AL8AwADBAMIAwwC9AMQAxQDGAMcAyADJAMoAvAC2AMgAywDMAM0AxwDOAMwAzwDQANEA0gDTANQA1QDUANYA1gDUANMA1wDWANgA2QDXANgA2gDbANkA2gDcANsA2gDdANwAvgDeAN8AxAC9AL8A4ADhAMQAwADhAOIA2ADaANkAvwDgAMQA4ADiAOEAwADiAMEA0wDjANYA1gDjANgA2ADkANoA2gDlAN0A3QDlAN8A3wDlAL4AvgDlAL8A5QDgAL8A5gDnAOMA5wDoAOMA4wDoANgA6ADpANgA2ADpAOQA5ADpANoA2gDpAOUA6QDqAOUA6gDrAOUA5QDrAOAA4ADsAOIA6wDsAOAA0QDQAOcA5wDQAOgA6ADQAOkA6QDQAOoA0ADPAOoA6gDPAOsA6wDPAOwA7QDPANEA7gDtANEA5gDjAO8A5wDmANEA8ADiAOwAwQDiAPEA8QDyAMEA8QC5APIAugDzALsA9ADzAPUAuAD0APUAuAD2ALYAyQDIALYAxQDKAMkAxgD3AMcA9wDOAMcA0wDSAMsA8QC6ALkAugD1APMA9gDJALYAyQDGAMUAzgD3AMwA9wDNAMwAywDNANMA4gDwAPEA8QD1ALoA9QD2ALgA9gD4AMkA+ADGAMkAxgD5APcA9wD5AM0A+QDvAM0A7wDjAM0AzQDjANMA8AD6APEA8QD6APUA+AD7AMYAxgD7APkA+wD8APkA+QDmAO8A7AD6APAA+gD9APUA9QD9APYA/QD4APYA+AD+APsA/gD8APsA/ADmAPkA7ADtAPoA/QD+APgA/gDRAPwA/ADRAOYAzwDtAOwA7QDuAPoA+gDuAP0A/QDuAP4A7gDRAP4AzADLAP8AAAHHAMwAGQDFABoAxQDHABoAAQHIAMoAvADIAAEBygCpAAEBxQCpAMoAxQAZAKkAAAEaAMcA/wCnAMwAzACnAAABywDSAKYA0gACAaYApgCoAMsAywCoAP8A/wCoAKcAAwEEAQUB3ADdAAYB3QAHAQYB2wDcAAgB1QDWAAkBCQHWANcACgGmAAIBoACdAAsBDAENAQMBBAEDAQ0BDQEOAQQBDgEPAQQBDwEQAQQBBAEQAQYBEAHcAAYBEQEIAQ4BCAEPAQ4BDwEIARABEAEIAdwAEQESAQgBEgETAQgBEwHbAAgB1QACAdQA1AACAdIACgECAQsBAgHVAAsBCwHVABQB1QAJARQBCQHXABMBEwEVAQkBCQEVARQBFQEWARQBFAEWAQsBFwGgAAsBGAEZARoBGwEcAQwBHAEdAQwBHgEfASABIAEfAQ4BHwEZAQ4BDgEZASEBIQEZARcBGQEYARcBIQEXASIBIgEXAQsBCwGdAAoBDAEdAQ0BHQEgAQ0BDQEgAQ4BDgEhAREBEQEhARIBIQEiARIBCwEWASIBIgEWARIBFgEVARIBFQETARIBEwHXANsA1wDZANsAHAAjASQBJQEmAScBGAEjAYkAIwEeAIkAKAGCACkBKQGCACoBKwF0ACkBdAAoASkBLAEqAYMAKgGCAIMAiwAdAC0BIwEYASQBGAEaASQBLgEvATABHwEmATEBGgEZATEBGQEfATEBMQEmATIBJgElATIBGgExASQBMQEyASQBHgEgATMBIAEdARwBLgEwARwBHAEwASABMAEzASABHwEeASYBJgEeAScBHgEzAScBgwCPACwBLAGPADQBjwCMADQBNAGMAC0BLQGMAIsAHQCJAB4AeQCJAB0AiwB5AB0AHAEbAS4BLwEuATUBNgE3ATgBKwFxAHQAbQA5AToBcQA7AXIANQE8AT0BPAE+AT0BPwFAAUEBPwFCAUABQwFEAUUBRAE2AUUBRQE2AUYBNgE4AUYBRAFBATYBQQFAATYBRwFIAT4BPAFJAT4BSQFHAT4BNQEbAUoBNQFKATwBPgFIAUUBLgEbATUBbABLAUIBOgFLAW0AbQBzADkBOQFzADsBaQBLAWwASwFpAG0ATAHBAPIABgEHAd4A3gAHAd8A3wAHAd0ATQEEAQYBSQE8AUoBRQFIAUMBbABCATwAPABCAT8BTQA8AE4BTwFMAUkATAHCAMEAGwEMAVABBQFNAVEBUgFTAVQBvQDDAL4AwwDEAOEAvgDDAFUBBgHeAFYBvgBVAd4A3gBVAVYBVgFNAQYBTQEFAQQBVwFJAEgASQBXAU8B4QDAAFIBUgHAAMIATAFYAcIAwgBYAVIB4QBSAcMAUgFUAcMAwwBUAVUBVAFRAVUBVQFRAVYBVgFRAU0BUQFUAVkBVAFTAVkBUwFSAVoBWgFSAVgBWAFMAU8BSABNAFcBQQE8AD8BQwFOAUQBRAFOAUEBTgE8AEEBSAFbAUMBQwFbAU4BWwFXAU4BTgFXAU0ADAEFAVABUAEFAVwBXQFIAV4BXgFIAUcBRwFJAV8BXwFJAVwBXAFJAVABSQFKAVABUAFKARsBSAFdAWABYAFdAWEBWwFhAWIBYQFdAWIBYgFdAVoBTwFXAWMBYwFXAVoBWgFXAWIBVwFbAWIBYQFbAWABWwFIAWABAwEFAQwBBQFRAVwBXAFRAV8BXwFRAUcBUQFZAUcBRwFZAV4BWQFTAV4BXgFTAV0BUwFaAV0BWgFYAWMBYwFYAU8BAQFkAbwAtQC3ADkAOQC3AGQBtwC8AGQB9AC4ALUAZQH0AKwAZQHzAPQAsQBmAbsAZgG5ALsAZwG5ALMAZwHyALkAaAFMAfIAZgGzALkAsQCzAGYBrwCxAGUBZQGxAPMAsQC7APMArACvAGUB9AC1AKwAtQCtAKwAtQA5AK0AZAGrADkAZwG0APIAtABoAfIAtABJAGgBSQBMAWgBswC0AGcBCgGeAKYAdAB2ACgBdgCCACgBdwB5AIsAeQB4AIkAGAGJAJYAoAAXARgBoAAYAZYAnQCgAJwAoACfAJwAnQCQAJ4ACgGdAJ4AGgAAAacAZAEBAaoAAQGpAKoAqwBkAaoAYAB0AHEAYQBgAHEAOwFzAHIAaQBsAGoAPAA7AGwASQBHAEgArQA5ADQALwE1AWkBNQE9AWkBRQE9AT4BRgE4AUUBNgFAATcBagFrATsBOwFrATkBbAFqAXEAcQBqATsBcQArAWwBLAEcACoBaQFsAS8BHAAkAWwBMAEvAWwBKQEcACsBKQEqARwAJAEyAWwBbAFpAT0BLAE0ARwANAEtARwAbAErARwAbAEyASUBPQFFAUIBQgFFAUABQgFLAT0BPQFqAWwBLQEdABwARQE3AUABSwE6AT0BPQFrAWoBJQEnAWwBJwEzAWwBMwEwAWwBRQE4ATcBOgE5AT0BOQFrAT0BAQAAADgABgAqADgAOAAqADIAIwAlADgADAALADgACAAFADgAOAAAAAwACwAIADgAOAAFAAYALwAjADgAOAClAAEAOAAyACwAOAAbAKUALAAvADgANAAlADoANAA2ACUAJQA2ADgAOgCyADQAsgCwADQANACwAK4AHgBtARwAIwFtAR4AHABtASMB",count:726}],link2:[{rgb:[1,1,1],positions:"ZQDa/QcAAADO/SAA0f/T/QcADgJU/wcAJgL3/xcAGAJp/4YA//+l/VUA9//E/ToAKADH/TcAkwDd/TIAGwEe/ggA3AHH/nMA7QG0/skAqQGZ/gcA6gH+/gcARwE2/jEAZgEx/mYAsQFo/oQAWwER/nIA+ADL/WcAcwCo/V0AAwCF/V4AtwDc/UsAmQC6/VoAcgFT/kIADwH4/VsABgHaAYECgwF+AXoCIwHkAQcAJgJ2+AAACwJ2+FD/JwKf+PL/ov/C/UsA8v1U/wcA3P2+/4kA2P3W/wYAc//j/QcA5/1t/5gAyP7z/W4Apf+m/VsAbv9z/V8AEf/g/V0Al/5X/gcA9/4E/kkAsP4w/lMAP/6X/nIAKf7Y/gcAA/4N/4MAK//8/Q0Ab//S/UYAmf4Y/nUA9v4S/gcA3P0qAJAAxP64AQcA0/7DAYoCRv/9AQYAY/5jAQcA7f2HAAcA4P3b+x4A2v3K+0YA9f2m/J4A8f80/UwA0f6m/XAAIP5//s0A4v/y/CAAQ//5/DcAT/5A/qMAEv4s/hIBO/4Q/scAKv7Z/dkA3P3c/tgB2/2Q/uMB4f1TAG4C3f1f/8IB/f12/QMBA/6T/IQA2/3n/aUBK/6M/EUAPf4I/YAAff7a/Y0AVv6c/Z0AhP4//W8Aif74/E8AcP6c/BcAU/5i/PX/lv+x/NX///6x/Pv/AADI/Oz/pP6B/OX/Hv4u/O7//f32++X/+P2/+5L/6f5m/Jn/zf9S/P/+AP8V/OD+hf8z/Nv+1v8o/Lj+1P9j+/P9nP/++uL9G/82+xb+n/+4+zL+HwC0+yL+/P/0+2X+b//5+4b+sv62+5j+pv7l+97+hv4//J//Bv4++yT/A/6K+0z/QP6G++f+4P2C+7H/Q/5F+8T+Nf65+x//cf7q+xz/Pf+j+0b+Wf/8+vP9Fv/9+g3+gf5A+37+1v/4+tv9UADb+0r+agAv++792AF8+wL/EQKp+5n/CAJA+0r/swEf/Jz/ugFj/P//AAIL/Pn/xgCm/N7/AgHI/BUAXAFx/NT/twAB+/n9CgEc+yL+7wCh+1X+rAAY/Lr+ZQHs+/D+7ADu+6L+xwGp+wf/JAKc++H/agCZ+yD+zwE1+9r+mwEY+5L+egGp+7b+bQGO+5H+QgEC+0L+JAJT//kBZgHc/YAAXAAI/TIAegHV/EIA4wGK/EsAsAG+/EgAGQJL/HkAEgFW/WEAigFh/YEAPAEU/VIAuQE2/q8ADALZ/j4B5wFh/u4AGQJJ/poBJQJ1/uEBJwLY/0ECIwKv/XoBJQLB+1oAsgFo/ZkA5AH9/JMA7AEd/g0BzAGs/cIAGAKTAAcAIAJIAF4CzgEhAXgCBAKxAHkCdgAQAokCNAAaAgYA+v8cAoECzP8aAgcAm/8SApsCNP/1AYUCf/5+AYQCTP5CAZcCD/7gAAcABf7JAIcCwv5GATcEav+DAXgE9P5yAS8ETv+qASQEbf+qAT0E0v/DATIEQv55/zMENP7Z/zgEMP6l/xYEuwCdATgE7QA3AX0E+gCBAS0ENAFRATIERQDBATIEGQCeAWsEuAGFADcEmQHTADIEngFRAGYEXgEUAUME+ABx/jUE+wAw/tEDMgGe/jkEtP/0/woFGAC2/wsFMQD//w4FzgERADQEjAHg/3sEzQGu/yoEwAFu/ygEowFA/0IEfwHy/jQEFgEy/7AEbwCj/qIEawBN/lgE1P9u/n0E9/8l/jIEQf9t/lgElf8z/jMEGf+l/nIEIP9f/jMEuP6u/jME7/4r/7QEbf4X/zgEt/6p/60EEwGj/8kEmQAD/8cEoP/d/sME2QDw/+cEnADj//oEdQCF//kE0P9b//kEiP+L//oEZP8JAPsEp/9VAAQF7f9YAAcFNwEVALYE7f4YAMsEm/5VAJQENv5IADAEUf6hADMENwHnAH8Eyv67AJEEg/4BATAEJ//iALUE/v8kAcAEQADmANsE/gBqAM8EZP9pAPIEwgCcANYEwgBNAOgE5v+2AO4EMgCNAPoE2QG6AFEDnwFaAaICpADYAWgD8AHL/5IDnQD//c8DsgHs/p0DJAKS/1kCAACU+2ACawDa+2cCEABd/KUCOgAP/QoD4/8O/Q4D/QCA/RADjwBI/IcCcQC7/ZEDCgCy/aADLgHK/HkCiAF6/Y8CXgEs/lcD6gG1/rECzQHz/k8DiwEd/gYDuwFF/tQCIQLM/CIB6wFF+w0BDQIc+60AuQD1+iECZgAa+z8CAAAb+0cC6f9n+1QCXQH4+r8BbQGl+8wBDgFJ+wUClAH5+oYBsQFc/MgBwQGU/U8CJQKe+AoADQJ2+K4AZwF2+KEBHwF2+NQBBQCk+SkCYQD6+uP9RwB2+Nz9zwB2+AH+zv92+Nv9LAF2+DP+swF2+K3+NQB2+CQCXADe+SQCmQB2+A4CzAF2+C0BywB3+PoBcQF2+Gf+if+Z+R0CRf52+LL+Ff52+AT/xv77+j3+lP4P+2T+FP+N+gIC1f52+MwBqP6O+a4B3f0h+zsA4v12+GsAAf5Z+98A2v12+OL/TP45+2kBGv5o+x4Bif54+I8BCP4I+d8ANv6i+DAB9P6y+xMCZv49+4oBOv9x+y4Cav8J+y8C8v13+GD/wP9M/JcCGf7U/8YDYP6p/nUDVP9+/TUDqv+g/YAD8f1W/BQBtP5F/asC7/6G/QkDt/5R/qUDff9i/TsD8f3u//IC2v33/1YC6f1m/hQC/P0g/60CO/4s/7sDPf+5/K0C3P7K/IACXf5K/gIDF/5V/GkBbv/t+2ACd/6T/AMCrP5M/B0CMf8g/F0CVv7X+5sBP/7N/OABKv6x/T8CM/6L/uICp/5vAVsDPP7nAFQDFv6LAE4DCP4oAGwDev92+BgCCf52+N4AMP52+CkBBv92+BH+fv52+Hf+hP92+Oj9HAKe+Pb/",indices:"AAABAAIAAwAEAAUABgAHAAgACQAIAAAACAAHAAAABwABAAAAAAAKAAkAAwAFAAsABQAMAAsADQAOAAsACwAOAAMADQAPAAoAEAALABEAEgATABAAFAAVAAYABgAWABQAFAAWABcAFwAYABkABgAIABYAGAAQABkAFgAJAAoACgAPABYACAAJABYAFgAPABcAFwAPABgAEAATABkAGQATABcADwANABgADQALABgAGAALABAAEAARABIAGgAbABwAHQAeAB8ABgAgAAcAIQAiACMAAQAHAAIAAgAHACQAJAAHACAAJQAiACEAJgAnACgAJwAmACkAIAAVACcAKQAgACcAKgArACwALAAtAC4ALgAtACEALQAvACEAKwAwADEAMAAgADEAJgAyACkAKQAyACwAMgAtACwALAArACkAKwAxACkAMQAgACkAJQAhAC8ALgAqACwAKgAzACsAKwAzADAAMAAkACAAIAAGABUANAAjACIANQA2ADcAOAA2ADUANAA5ACMAOgA7ADwAKAAVAD0AKAAnABUAKAA+ACYALQA/AC8AQABBAD0AQQAoAD0ALQAyAEIAQwBEAEUAQgBEAD8ARABDAD8APwBDAEYARgBDAEcAPwAtAEIARgBIAEkASQBIACIALwA/ACUAPwBGACUARgBJACUAJQBJACIAOwBKADwASwA6ADwAOwBMAEoASgBLADwATQBLAE4ATwA+AFAAPgBRAFAARQBKAEMASgBFAEsARQBQAEsASwBQAE4AUABRAE4AUQBSAE4ATgBSAE0AUgBTAE0AUwBUAE0AVQBWAEEAVgBTAEEAUwBSAEEAUgBRAEEAQQBRACgAKABRAD4APgBPACYAJgBPADIAMgBPAEIATwBQAEIAQgBQAEQARABQAEUAQwBKAEcASgBMAEcAQABXAFUAUwBWAFgAWABUAFMATQBZAEsAWQBaAEsASwBaADoAOgBaAFsATQBUAFkAXABYAFYAVgBVAFwAVQBdAFwAXABdAF4AXgBdAF8AXwBgAF4AXQBVAFcAYQBiAGMAYQBkAGUAZQBkAGYAZABnAGYAZgBnAGAAQQBAAFUAXQBgAF8AYABnAF4AZwBoAF4AaABpAF4AXgBqAFwAXABqAFgAawBsAG0AbABuAFsAbwBrAG0AbABwAG0AWgBZAFsAWwBZAHAAWQBxAHAAcABoAG0AaAByAGMAYwBzAHQAOgBbAG4AbABbAHAAbQBoAG8AbwBoAHUAaABjAHUAYwB0AHUAWABqAFQAVABqAFkAWQBqAHEAagBeAHEAcQBeAHAAXgBpAHAAcABpAGgAZwBkAGgAaABkAHIAcgBkAGMAYwBkAGEAYQB2AGIAXQB3AGAAdwBmAGAAYQBlAHgAdgBhAHgAeQB6AHsAfAB9AH4AfwCAAIEAggB4AIMAgwB4AIQAfwCFAFcAVwCFAF0AXQCFAHcAfQB8AIEAgQB8AIYAgQCGAH8AfwCGAIUAZgB3AGUAhwCFAIYAfAB+AIgAeQCIAHoAiAB+AHoAfgCJAHoAeABlAIoAiwCMAHkAeQCMAIgAiACMAI0AjACOAI0AjwCDAIwAjACDAI4AjgCDAIQAdwCEAIoAhAB4AIoAZQB3AIoAdwCFAIQAhQCHAIQAhwCGAIQAhACGAI4AjgCGAI0AhgB8AI0AjQB8AIgABQAEAJAAEQALAAwAEwASAJEAFAAXABMAFQCSAD0AfwBXAEAAkwCBAIAAlAB9AJUAlQB9AIEAlACWAH4AQACSAH8AEwCRAJcAFAATAJcAkQCYAJcAFACXABUAFQCXAJIAkgCXAJkAmQCXAJgAmgARAAwADAAFAJsAmwAFAJAAEgARAJEAEQCaAJEADACcAJoAnQCbAJ4AnQCcAJsABACfAJAAkACeAJsAnQCgAJQAlACgAJYAoAChAJYAfgCWAIkAfgB9AJQAQAA9AJIAogCYAJwAmACRAJwAnACRAJoAlQCBAJMAlQCjAJQAlACjAJ0AnACdAKQApACdAKMApACjAKUApQCjAKIAowCVAKIAogCVAJMAmQCTAIAADACbAJwApAClAJwAnAClAKIAogCTAJgAmACTAJkAmQCAAJIAkgCAAH8ApgCfAAQAnwCmAKcAqACpAKYAqQCnAKYApgAcAKgAGwCoABwAHACqABoAqwCsABwArACqABwArQA3AK4ANwCvAK4ArgCsAK0ArQCsAKsANgCvADcAsAA2ADgAOACxALAAsgCzADgAOACzALEASACzADkAOQCzALIAIgBIADQANABIADkAtAC1ALYAtwC4ALkAugC7ALwAvQC+AL8AvwC+AMAAwQDCAL0AwwDEAMUAwADGAMQAxwDIAMkAygDLAMwAzQDOAM8A0ADPANEA0QDPAM4A0gDRANMAyQDSANMA1ADHAMkA1ADVAMcA1gDXANUA2ADZANYA1gDZANcA2gDbANgA3ADbANoA3QDeANwA3wC6AN4A0wDUAMkA2gDdANwA3QDfAN4AugDfALsAzgDgANEA0QDgANMA0wDhANQA1ADiANUA1QDiANYA1gDiANgA2ADiANoA4gDdANoA4wDkAOAA5ADlAOAA4ADlANMA0wDlAOEA4QDlANQA5QDmANQA1ADmAOIA5gDnAOIA4gDnAN0A3QDoAN8A5wDoAN0AzADLAOQA5ADLAOUA5QDLAOYAywDKAOYA5gDKAOcA5wDKAOgA6QDKAMwA6gDpAMwA4wDgAOsA5ADjAMwA7ADfAOgAuwDfAO0A7QDuALsA7QDvAO4AuADCALkAvgDwAMAA8ADGAMAAzgDNAMMA7QDxAO8A7wDxAPIA8QDzAPIA8gDzALQAtADzALUAuQDCAMEAwgC+AL0AxgDwAMQA8ADFAMQAwwDFAM4A3wDsAO0A7QDzAPEAtQD0ALgAuAD0AMIA9AD1AMIA9QC+AMIAvgD2APAA8AD2AMUA9gDrAMUA6wDgAMUAxQDgAM4A7AD3AO0A7QD3APMA9QD4AL4AvgD4APYA+AD5APYA9gDjAOsA6AD3AOwA9wDpAPMA8wDpALUA6QD6ALUAtQD6APQA+gD1APQA9QD7APgA+wD5APgA+QDjAPYA6ADpAPcA+gDqAPUA6gD7APUA+wDMAPkA+QDMAOMAygDpAOgA6QDqAPoA6gDMAPsAxADDAPwA/QDAAMQAvwDAABsA/gC9ABoAGgC9AL8AqgDBAP4A/gDBAL0AuQDBAKwAwQCqAKwA/gAaAKoAvwAbABoA/QAbAMAA/ACoAMQAxACoAP0AwwDNAKcAzQD/AKcApwCpAMMAwwCpAPwA/ACpAKgAxwDVAAAB0ADRAAEBAQHRANIAAgGnAP8AAwEEAQUBBQEGAQcBCAHHAAABBgEFAQkBCQEFAQQBCQEIAQYBCAEKAQYBBgEKAQsBCwEKAdcACgHVANcADAEIAQkBCAEAAQoBCgEAAdUADAENAQgBDQEOAQgBDgHIAAgBCAHIAMcADgHSAMgAyADSAMkA0AD/AM8AzwD/AM0AAgH/AA8B/wDQAA8BDwHQABAB0AABARABAQHSAA4BDgERAQEBAQERARABEQESARABEAESAQ8BDwETAZ4AoQAUARUBFgEDARcBGAEXARkBGgEbARwBHQEUARsBGwEUAR4BHgEUARMBFAGhABMBHgETAR8BHwETAQ8BDwGeAAIBAwEWAQQBFgEcAQQBBAEcAQkBHAEbAQkBCQEbAQwBGwEeAQwBDAEeAQ0BHgEfAQ0BDwESAR8BHwESAQ0BEgERAQ0BEQEOAQ0BHQAgASEBIgEdASMBJAEXARgBoQAgAYkAIAEfAIkAJQGCACYBJgGCACcBKAF2ACYBdgAlASYBKQEnAYMAJwGCAIMAiwAeACoBIAGhACEBoQAVASEBJAErASwBLAErAS0BFAEdAS4BHQEiAS4BFQEUASEBFAEuASEBGgEcAS8BLwEcARYBJAEsARcBLAEtARcBFwEtARYBLQEvARYBGwEaAR0BHQEaASMBGgEvASMBgwCPACkBKQGPADABjwCMADABMAGMACoBKgGMAIsAHgCJAB8AewCJAB4AiwB7AB4AKwEkATEBKAFzAHYAbwAyATMBcwA0AXQANQE0ATIBMQE2ATcBNgE4ATcBOQE6ATsBOQE8AToBPQE+AT8BPgFAAT8BPwFAAUEBPgE7AUABOwE6AUABQgFDATgBNgFEATgBRAFCATgBMQEZAUUBMQFFATYBOAFDAT8BJAEYATEBGAEZATEBbgBGATwBMwFGAW8AbwA1ATIBawBGAW4ARgFrAG8ANQF0ADQBAwEFAUcBSAG7AO4ASQHeALoA2wDcAEoBCwHZANgABgELAUsBBwEGAUsBFwEDARkBRAE2AUUBPwFDAT0BbgA8ATsAOwA8ATkBTAA7AEwBSAG8ALsASQFNAU4B3ABPAUoBTwHcAN4A2wBKAdgA2ABKAUsBSwFKAVABCwHXANkA2ABLAQsBSwFQAQcBRwEFAQcBUQFSAVMBUwFSAUcASAFRAVQBUQFTAVQBugC8AEkBSAFVAbwAvABVAUkB3gBJAU8BSQFOAU8BTwFOAUoBUAFKAQcBRwEHAUoBVgFKAVcBSgFOAVcBTgFNAVcBTQFJAVgBWAFJAVUBRwBMAFMBOwE7ADkBPQFMAT4BPgFMATsBTAE7ADsBQwFZAT0BPQFZAUwBWQFTAUwBTAFTAUwAAwFHARkBGQFHAVoBWwFDAVwBXAFDAUIBQgFEAV0BXQFEAVoBRAFFAVoBWgFFARkBQwFbAV4BXgFbAV8BWQFfAWABXwFbAWABYAFbAVgBSAFUAWEBVAFTAWEBYQFTAVgBWAFTAWABUwFZAWABXwFZAV4BWQFDAV4BRwFKAVoBWgFKAV0BSgFWAV0BXQFWAUIBVgFXAUIBQgFXAVwBVwFNAVwBXAFNAVsBTQFYAVsBWAFVAWEBYQFVAUgBtwC5AK4AtgC1ALcAtQC4ALcAYgG2ADYAYgG0ALYAsQBjAfIAYwHvAPIAZAHvALMAZAHuAO8AZQFIAe4ASABSAVEBYwGzAO8AsQCzAGMBsACxAGIBYgGxALQAsQDyALQANgCwAGIBtgC3ADYAtwCvADYAtwCuAK8ArACuALkAZAFIAO4ASABlAe4ASABRAWUBUQFIAWUBswBIAGQBdgB4ACUBeACCACUBeQB7AIsAewB6AIkAoQCJAJYAoACeABMBEwGhAKAAngCgAJ0AngCQAJ8AAgGeAJ8AAgGfAKcAGwD9AKgAYgB2AHMAYwBiAHMANQF1AHQAbwB1ADUBawBuAGwAOwA6AG4AUgFGAEcASABGAFIBKwExAWYBMQE3AWYBPwE3ATgBZwFoAUABQAFoAUEBQQFoAT8BQAE6AWcBaQFqATQBNAFqATIBawFpAXMAcwBpATQBcwAoAWsBKQEdACcBZgFrASsBHQAhAWsBLQErAWsBJgEdACgBJgEnAR0AIQEuAWsBawFmATcBKQEwAR0AMAEqAR0AawEoAR0AawEuASIBNwE/ATwBPAE/AToBPAFGATcBNwFpAWsBKgEeAB0APwFnAToBRgEzATcBNwFqAWkBIgEjAWsBIwEvAWsBLwEtAWsBPwFoAWcBMwEyATcBMgFqATcBAgAkAKsABAADAKsAJAAwAKsAqwAwADMAIQAjAKsADgANAKsACgAAAKsAqwAAAAIAqwADAA4ADQAKAKsALgAhAKsAqwCmAAQAqwAjAK0AqwAzACoAqwAcAKYAKgAuAKsANwAjADkANwCtACMAOQCyADcAsgA4ADcANwA4ADUAHwBsAR0AIAFsAR8AHQBsASAB",count:726}],link3:[{rgb:[.039,.051,.055],positions:"pwAiAmv/XwEGAlX+SAERApL+9wJEAgv+RwV8Aur/ugR4ArX+CwV1At4AwwR1Ak8BPQR5AtUBUAN7AiAC4QF9AqIBeQNrAhP+HQSEAjT+xASHArL+8ASHAur+xASFArL+QgWHArD/IwWHAkn/OgWHAo3/RwWHAtP/SgWHAvf/OgOHAiYCXgKtA8gBFgOHAiUChQSGArABSwSHAtkBCwSHAvoByAOHAhICgQOHAiECOgOHAiYC8gKHAiECzwKHAhsC8gKHAiECrAKHAhMCzwKHAhsCrAKHAhMCigKHAggCaAKFAvoBCgKFAsYBKQKFAtoBKQKHAtoB7gGGArEB7gGHArIB7gGGArEBaAKFAvoBKQKFAtoBCgKFAsYBhASGAnb+lwQxA47+hASFAnb+xASHArL+7wS+Avb+FAWHAij/OgWHAo3/SgWIAvf/QgWHArD/RwWHAtP/SgWHAvf/SQWHAj4AugSHAoABoQSRAqIBhgSHArABSwSHAtkBVwTsAr8BCwSHAvoBgQOHAiECyAOHAhICZgOUAiMC6gPRAvwBigKHAggCSAKHAuwBKQKHAtoB7gGHArIBFAWHAij/SQWHAj4APwWHAoUAKwWHAsoADQWGAgsB6ASHAkgBugSHAoABxASFArL+SAKFAusBSAKFAusBSAKHAuwBFgOHAiUChQSGArABhgSHArABDQWGAgsBDgWHAgwBUgSFAlL+UgSFAlL+UgSGAlL+UgSGAlL+HQSGAjP+hASGAnb+hASFAnb+HQSEAjT+HQSGAjP+vQGGAoYBvQGGAoYBkgGGAlUBkgGGAlUBOwF9AxAA1QG1A/f+mAFrA8b+FgLzAyr/7wHyA2P/DQN4Ayv+JgPhA4D+YgN9Azb+oQPyA63+FQTIA7X+MATyA/z+BQTyA9r+1APyA8D+SQKwA4T+4QFsA3v+ZgTOA+H+9ASzA63/pgTyA8L/BAWqAwoAqQTyA1YABAWqAwoAAwWrAzcA6wSuA6UAsAS5AxgBCQWRA6P/UAT1AwcBCwTRA58BpgOBA0b+YgN9Azb+lwFqA8X+lwFqA8X+lwFpA8X+cAJvAzb+HQLNAvT9pAJyAy3+2AJ1Ayn+DQN4Ayv+DQN3Ayv+2AJ1Ayn+pAJyAy3+aAFqAwr/mAFrA8b+lwFqA8X+lwFqA8X+lwFpA8X+OQM9Axj+9gI9AxL+OQM+Axn+ewM+AyX+ewM+AyT+ewM/Ayb+ewM+AyX+OQM+Axn+9gI+AxL+9gI+AxP+9gI9AxL+OQM9Axj+iQLLAuD99gI9AxL+9gI+AxL+9gI+AxP+9gI+AxL+9QI+AxP+9AI+AxL+8wJCAxT+9QI+AxP+9AJAAxT+9AI/AxT+8wJCAxT+9AJCAxT+9AJBAxT+9gI9AxL+9AJBAxT+9AJBAxX+fQNCAyj+fQNBAyj+fANCA0n+fANBA0j+fANBA0n+fQNBAyj+fANCA0n+fANBA0n+fQNBAyj+fQNAAyj+fANBA0j+fQNAAyj+fANAA0j+fQNAAyf+fANAA0j+fQNAAyf+ewNAA0j+fAM/Ayf+fAM/Ayf+fAM/Ayb+ewNAA0j+ewM/Ayb+egM/A0j+fAM/Ayb+egM/A0j+ewNAA0j+9gJAA0j+9wI/A0j+9gI/Ay7+9gJBA0j+9gJAA0j+9QJAAy7+9gJCA0n+9QJBAy7+IwN+A1r+9AJBAxX+9AJAAxT+9QJBAy7+9gJCA0n+9gJBA0j+9QJBAy7+9QJAAy7+9AJAAxT+9AI/AxT+9gJAA0j+9QJAAy7+9wI/Ay7+9gI+AxP+9gI/Ay7+9QI+AxP+9wI/A0j+bANfAy/+agNiA1H+bANfAy/+EwN3Ay3+TgN7AzL+EwN3Ay3+EwN3Ayz+EwN3Ayz+EwN3Ayv+EwN3Ayz+EgN3Ayv+EgN3Ayv+EQN3Ayv+EQN3Ayv+EAN3Ayv+XgN8AzX+XQN8AzX+XAN7AzT+XQN8AzX+XAN8Azb+XAN8Azb+XAN7Azb+XAN7Azb+XAN7Azf+XAN7Azf+jQCFAof/ngCFArX/nQCHArb/igCFAm7/jACFAlX/ywCFAur+hQCbAn//igCFAm7/lwCnAqX/iwCGAlX/iwCGAlX/jACFAlX/1wCHAoj+2ACFAon+AQGGAk3+SgGFAi/+pwGHAr/9pwGGAsD9aQGJAub96QGIAp/96QGGAqD9pwGGAsD9MgGHAhb+BAKFAsL96gGFAqL96QGGAqD96QGFAqH96QGFAqH96gGFAqL9dwG/Avb9AgKdApX9pwGHAr/96QGIAp/9AQKHApj9rQCvAuP+AQGGAk3+1wCHAoj+2ACFAon+QQKJApj9TAKIApz9PwKHApn9GgKHApX9AQKHApj9BAKFAsL9SwKFAp79MwKFApj9SwKGAp39MwKGApf9PwKHApn9MwKGApf9TAKIApz9SwKHApz9SwKHApz9MwKFApj9zQDAAjL/sACFAmT/zQDAAjL/wwDBAmz/3gDBAvn+LAHAAm/+9ACFApr+LAHAAm/+CAHAAqL+VQHBAkL+1QHAAuj9jAGFAvj91QHAAuj9oQHAAgX+DgLCAtH9KAHAAj7+MgGHAhb+0gB/AmT/zwCAAmr/5ADKAnr/4ADIAn3/5wDLAnf/5ADKAnr/3QDGAn7/ywCCAm7/3QDGAn7/ywCCAm7/ugCEAnL/yQDFAoD/8QDNAjz/AQHNAgj/0gB/AmT/8QDNAjz/7ACFAun+/wDIAvr+8ADBAu7+7ACFAun+3wCFAt/+5wDAAvD+3wCFAt/+5wDAAvD+ywCFAur+xwCFAvj/uwCFAuT/7gB/AjgAxwCFAvj/xgCFAvj/uwCFAuT/ugCFAuT/xgCFAvj/xQCGAvn/ugCFAuT/xQCHAvn/uQCHAuX/xQCGAvn/uQCGAuX/xQCGAvn/uQCGAuX/1ACFAhIA4gCGAi0A0wCHAhMAxQCHAvn/uQCHAuX/0wCHAhMAxACIAvn/xACIAvn/8ACFAkcA6QCFAjoAAAGFAmIA4gCFAi0A4gCFAi0A6QCFAjoA4gCGAi0AAwG/AkMA8ACFAkcAAAGFAmIA2wCFAh8A2wCFAh8A1ACFAhIABgF9Avn+AwGFAqz+hwGFAgH+XAGFAkv+XwGFAkH+YwGEAo/+jQCFAof/NgGFAnb+jAGFAvj9DwKFAsr9EAKFAs79hwGFAgH+mQGFAhf+SgGFAi/+BAOFAtv9EAKFAs79DwKFAsr9UQGFAi/+PgOFAuv9VQOAAgf+DAKFAuD99ACFApr+AwGFAqz+XgGFAjr+UQGFAi/+XwGFAkH+XgGFAjr+mQGFAhf+twHNAiT+swHMAib+rQHKAib+qQHIAiX+rQHKAib+mwHBAhn+mwHBAhn+mwHAAgz+mwHAAgz+nwHAAgf+oQHAAgX+nwHAAgf+GgLMAvT95wHNAgn+5wHNAgn+GgLMAvT9HALMAvP9HgLLAvL9HgLLAvL9HgLMAvL9IQLKAu79IQLKAu79IwLGAuf9IwLFAuT9IwLFAuT9HgLBAtf9GgLBAtP9GgLBAtP9FgLBAtH9FgLBAtH9bwHMAl3+SQHLAof+SQHLAof+KgHMArT+XAGFAkv+cAHMAlz+cAHMAlz+cQHLAlr+cgHKAlb+cgHIAlL+cgHIAlL+cAHEAkr+cAHEAkr+bgHDAkf+XAHAAj/+XAHAAj/+3QDCAvn+zQDCAjL/3gDCAvn+3QDCAvn+3QDDAvn+ywDDAjH/wwDCAmz/wgDDAmz/3QDDAvn+3QDDAvj+qQDAAqT/wgDDAmz/ywDDAjH/3QDDAvj+1QDBAhX/zQDBAjL/xwDBAk//zQDBAjL/zQDCAjL/xwDBAk//1QDBAhX/3gDCAvn+zQDCAjL/wwDCAmz/CQHDAp/+CAHCAqH+CQHCAp/+CgHCAp/+CAHCAqH+CgHBAp/+BwHAAqn+CgHBAp/+CQHBAq/+UwHCAkP+KwHDAm7+KwHCAm/+CQHDAp/+KgHDAm7+UgHDAkL+UwHDAkP+CQHDAp/+KwHDAm7+KgHDAm7+UgHDAkL+UwHDAkP+UwHBAkP+UwHCAkP+LAHCAm/+UwHBAkP+LAHBAm/+PwHBAln+UwHBAkP+GgHBAof+LAHBAm/+PwHBAln+UwHBAkP+LAHCAm/+CgHCAp/+GgHBAof+UwHCAkP+KwHCAm/+CQHCAp/+VQHBAkL+oQHCAgX+oQHCAgT+oQHDAgT+oQHBAgX+oQHDAgT+1AHDAuf9CwLDAtD91AHDAub91AHDAuf91QHCAuj9oQHCAgT+oQHCAgX+1QHCAuj9DgLCAtH9CwLCAtH9CwLDAtH91AHDAub9CwLDAtH9CwLDAtD91QHCAuj91QHBAuj98AHBAtz9oQHBAgX+uwHBAvb91QHBAuj98AHBAtz9uwHBAvb9oQHCAgX+oQHBAgX+CwLCAtL9CwLCAtL9CwLCAtH91QHCAuj9CwLCAtH9CwLDAtH9PQK/Aqv99wHCArb99wHCArb9+AHDArj92QDDAsL+uQDDAg7/+AHDArj9KwL1A+sAfQL1AzUB9AL1A38B9QH1A4sADAL1A70AkAT0AywAjQTzA+T/lgL0A8b+FgLzAyr/QAL1AyX/HgL0A1D/ygH2AyoACgL1A2//+gH1A5D/BQTyA9r+BAT0A/3+xQP0A9n+JQT0Axn/PwT1AzL/WQT0A1b/dwTyA1D/egT0A5b/awT0A3X/4QH0AxQAzQH0A87/4QH0AwIA5QH0A97/+AH0A5n/nAP0A8r+OQP1A20BdgP1A38BbAPzA2cBkAP0A2EBswP0A1YB1AP0A0cB+gP0AzEBFgT0AxsBNQTzA/wATQT0A+EAYQT0A8MAYQT0A8MAggT0A3oAiwT0A1cAkAT0AzMA3ADGAn7/4ADIAn3/5ADKAnr/6ADOAn3/4ADIAn3/3ADGAn7/4ADIAn3/8gDNAjz/8gDNAjz/AQHNAgj/PwOGAun9BQOGAtn9BQOHAtj9PgOFAur9PgOFAuv9PwOGAun9PgOFAur9BAOFAtv9BQOGAtn9PwOHAuj9BQOHAtj9BQOIAtf9PwOHAuj9PwOIAuj9PwOIAuj9BQOIAtf9PwOJAuf9BQOJAtf9BQOJAtf9BQOKAtf9PwOJAuf9BQOKAtf9OQONAub9RQOFAu39RQOFAu39RQOFAuz9RQOGAuv9RQOGAuv9RQOHAur9RQOHAur9ZQOHAvH9ZQOHAvH9ZAOGAvL9ZAOGAvL9ZAOGAvL9ZAOFAvP9RQOFAuz9ZAOFAvP9ZAOFAvT9RQOFAuz9ZAOFAvT9AQPEAur9swOeAgb+swHMAib+sgHNAif+twHNAiT+qQHIAiX+5wHNAgn+twHNAiT+GgLMAvT9GgLNAvT9GgLNAvT9HgLMAvL9HALMAvP9HgLMAvL93gDCAvn+KgHDAm7+ywDDAjH/KgHMArT+JwHPAsD+OQHMAp3+SgHMAof+GgHGArr+dgGGAjEBRQGFAuUARQGFAuUAdgGGAjEBfAOFAvn9lAOGAv79wwOFAg3+fAOFAvn9wwOFAg3+lAOGAv79cQHMAlr+bgHMAl7+cgHKAlb+nQCHArb/ngCFArX/jgJ8AiL+0gB6An3/QgNzAg7+9wI/Ay7+9wI/A0j+egM/A0j+9gI+AxP+EgN3Ayv+9AJBAxX+9AJBAxX+9AJBAxT+EwN3Ayz+9AJCAxT+fQNAAyj+fQNBAyj+fQNCAyf+fwNCAyb+fgNDAyf+fQNCAyj+fAM/Ayf+ewM+AyX+ewM+AyT+XgN8AzX+fgNDAyf+bgNgAy3+bgNgAy3+bQNgAy3+XgN8AzX+bANfAy7+bANfAy7+bANfAy/+bANfAy7+fQNCAyf+bQNgAy3+bQNgAy3+fgNDAyf+bQNgAy3+fQNCAyj+fQNCAyj+fQNCAyf+fQNCAyf+KAHMArX+KAHMArb+IgHKArn+JwHLArf+KAHMArb+HgHIArr+HAHGArr+BwHAAqn+CQHBAq/+IgHKArn+JwHMArf+KQHMArX+KQHMArX+KAHMArX+KgHMArT+JwHLArf+JwHMArf+IgHKArn+HgHIArr+HAHGArr+GgHGArr+HgHIArr+KgHMArT+SQHMAof+KgHMArT+OQHMAp3+SQHMAof+SgHMAof+bgHMAl7+cQHLAlr+cQHMAlr+cgHKAlb+bwHMAl3+bgHMAl7+SwKFAp79SwKGAp39fwNCAyb+OQM9Axj+qwE0A33+JAXbAnH/PQXpAuz/SgWIAvf/PwWHAoUAFgVCA6MAKwWHAsoAAwXiAgABDgWHAgwB2wTlAkEB6ASHAkgBnwPfAg4CWwL0Aw3/+QHuA67/5QH0A97/5gHtAx4AQQL0Ayb/HgL0A1D/WwLzAw7/4gHzAxQA4QH0AwIA+wH0A5H/CwL0A3D/CgL1A2//HgL0A1D/+AH0A5n/CwL0A3D/+wH0A5H/NQL0AzP/WwLzAw7/WwL0Aw3/QQL0Ayb/+gH1A5D/NQL0AzP/6AH0A1wA7QH0A24A4wH0AzgA6AH0A1wA7QH0A24A4wH0AzgA5AHzAzgA7QH0A24A7gHzA24A5AHzAzgA4QH0AxQA4gHzAxQAEAP0A77+oQPyA63+yALzA7D+OQPzA7z+OQP0A7v+OQP0A7v+OQPzA73+OQPzA7z+EAPzA7/+EAP0A77+OQPzA73+EAPzA7/+/QLyA8L+ewLzA/b+qQL0A9v+/QLyA8L+GQPzA2kBOQPzA2sBOQPzA2oBGAP0A2oBOQP0A2wBOQPzA2sBGAP0A2oB9wHzA4oA9QH1A4sADgLzA7wADAL1A70AKwL1A+sALAL0A+oAOQP1A20BOQP0A2wBVQP0A7z+VQP0A7z+JATzAxr/KwTyAyH/PQTzAzT/kATyAxMAkATzAwgAjQTzA+T/kATyAxMAjwTzAywA+QPzAzABFgTzAxoB9wPtAy0BkAP0A2EBXQPzA2kBbAPzA2cBVAT0A1D/nAPzA8v+eQP0A8H++QPzAzAB0wPzA0YB1AP0A0cBnAPzA8v+nAP0A8r+owPzA83+xQP0A9n+AwTzA/7+JATzAxr/JQT0Axn/PQTzAzT/agTzA3b/hATzA7n/egT0A5b/hQT0A7n/hgTzA8D/kATzAwgAjwTzAywAiwT0A1cAdATzA5wAYATzA8IAggT0A3oATATzA+AATQT0A+EANQTzA/wAFgTzAxoBFgT0AxsB0wPzA0YBswP0A1YBXQPzA2kBOQP0A2wB+gP0AzEBawT0A3X/VAT0A1D/eQP0A8H+dwTyA1D/NAP0A6H+OwLzAwL/OwLzAwL/1APyA8D+ewNAA0/+WwN4A2D++AI+A0/+9wI+A0/+9wI+A0/+9gJAA0j+9wI/A0/+9wI/A0/+9wI/A0/+9wJAA0/+9wJAA0/++AI+A0/+ewNAA0/+ewNAA0/+ewM/A0/+ewM/A0/+ewM/A0/+egM+A0/+egM+A0/+eQM+A0/+eQM+A0/+OQPzA2oBSgPtA2YBpwPtA1MBPgTtA+sATATzA+AAYATzA8IAdgTtA4QAjATtAxwAhgTzA8D/XwTtA3H/iATtA+H/agTzA3b/JQTtAyD/KwTyAyH/9gPtA/r+oQPtA9P+owPzA83+TQPtA8H+9wHzA4oADgLtA6oALAL0A+oADgLzA7wAXALtAxQBfgLzAzMB0wLtA1QBGQPzA2kBegLtA/z+ewLzA/b+/QLtA8b+qQL0A9v+",indices:"AAABAAIAAwACAAEABAACAAUABgACAAQABgAHAAIABwAIAAIACQACAAgACQAKAAIACgAAAAIACwACAAMADAACAAsADAAFAAIADQAOAA8AEAARABIAEAATABQAFQAWABcAGAAZAAgAGQAaAAgACAAaAAkAGgAbAAkAGwAcAAkAHAAdAAkAHQAeAAkAFgAfACAAHwAWACEAHgAiACMAIwAkACUAJgAnACgAJgAoACkAKAAqACsAEQAEAAUALAAKACMALQAuAAoAKQAKAC4ALwAwADEADwAxADIAMgAxADAADgAzADQANQA2ADcANgA4ADcAOAA2ADkAOQA2ADoAOwA8AD0APAA+AD0APgA/AEAAQQBCAEMAQgBEAEMAQwAWABUAFwAWACAAIQAWAEUARQBGACUARwAWAEgADgBJAAUASQARAAUAEQAQAAQAEAAUAAQASgAEABQASgBLAAQABgAEAEwATAAEAEsATABNAAYATgAGAE0ABgBOAAcATgBPAAcABwBPAAgACABPABgADgAFAA8ABQAxAFAACgAsAFEAIwAJAB4AUQAtAAoAJwBSACgAUgAlACgAKAAlAFMAHgAdAFQAGQBVAFYAVQBPAFYATgBXAFgAVwBMAFgACQAjAAoADABZAAUAWQAxAAUAWgBbAC8ALwBcADAAXABdADAAXgBfAFoAWgBgAFsAYABhAFsAYgAKACkAYwBIABYAFgBkAGMAKwAqAGMAZQAKAGIAZgBnAGgAaQBnAGoAZwBmAGoAawBsAG0AMABuAG8AcABvAHEAcgBxAG8AbgByAG8AcwBnAGkAcwB0AGcAbwBwADAAcAB1ADAAdgB3AHgAdwB5AHgAegB5AHsAewB5AHwAeQB9AHwAdgAwAHUAegB+AHYAegB7AH4AfwCAAH0AgQBsADAAgQAwAIIAbQBsAIEAbABuADAAZwB0AGgAaAB0AIMAhAB0AIUAcwCGAIcAiACJAIcAiACHAIYAigCLAIkAbACMAI0AcwBsAIYAbACNAIYAbABrAIwAZgBoAI4AjwCQAI4AjgCRAJIAkwCUAJUAlgCXAJUAlQCXAJMAmACZAJoAmwCcAJoAnQCeAJ8AoAChAJUAogCjAKQAnwClAJ0AnwCmAKUApwCoAKkAqgCrAKwArQClAKEAoQClAKQApQCmAKcApgCuAKcApwCuAKgArgCvAKgAsACxALIAswC0ALUAtgC1ALcAuAC5ALMAugC7ALwAuwC9ALwAvgC/AMAAvwDBAMAAwgDDAMQAxQDGAMcAxwDIAMkAygDLAMwAzQDOAM8A0ADRANIA0QDTANIA1ACvANUA1gDXANgA1wDZANgA2ADZANoAzwDbAKgAzACpANwA3ACpAN0AzACnAKkA3gDfAOAA3wDhAOAA3gDgAOIAsACyAOMAsgDkAOMA5ADSAOUA0gDmAOcA6ADpAOcA5wDqAOsA7ADtAOsA7gDvAOsA6wDwAPEA8gDzAPQA9QD2APQA9AD2AOcA9wD4AOcA+QD6AOcA5wD7ANIA/AD9AP4A/wAAAQEB/AACAQMBBAECAf4A/gACAfwAAgEFAQMBBgEHAQMBAQEAAQgBCQEKAQsBDAENAQ4BDwEQAQwBDAEQAQ0BDgERARIBEgERARMBEQEUARMBFQEWAREBEQEXARgBGQEaAQ4BDgEaARsBGwEaARwBGgEdARwBCAEAAQUBBQECAR4BBQEeAQgBCgESAQsBHgEfASABCAEKASEBIgEjASQBJQEWASYBFgEVASYBJwEYASUBGAEXASUBKAEpASoBKQErASoBKgErASwBLQElASQBJAElASIBJQEaASIBKQElASsBEAEPASYBHQEaASUBLgEvASQBMAEqASwBMQEnASUBAQEyATMBNAE1ATMBNgEyAQEBCwE3ATgBOQE6ATgBOwE3AQsBEwE8AT0BPgE/AT0BQAE8ARMBHwFBAUIBQQEZAUIBQgEZAQ4BQwFEAUUBRQFEAUYBRwFDAUgBRgFEAUkBRAFKAUkBSwFMAU0BSwFNAU4BMwFOAU0BTgEzATUBTwFQAVEBUgFRAUcBUQFQAVMBUAFUAVMBVAFVAVYBVgFVAVcBVQFYAVkBWQFaAVsBWAE2AVsBXAFdAV4BXwFgAWEBYQFgAWIBYwFkAWUBZgFnAWgBZwFpAWgBagFrAWUBYwFsAWQBbAFtAWgBaAFtAWYBbQFuAW8BbwFuAXABcAFxAXIBcwFxAQQBXgF0AXUBdgF0AV4BXgF1AXcBeAF5AXoBXwFeAWABewF8AX0BBAFxAXsBewFxAXwBfAFxAW0BbQFsAX4BfwGAAV4BgAFgAV4BfAFtAXkBbQF+AXcBdwF+AV4BgQFTAYIBWQFbAQkBEgGDAQsBhAGFAYYBMwFNAYcBggGIAYYBEgGJAYMBigExAYsBVgFXATgB/wAzAYcBjAGNAY4BjwGQATEBkQEnATEBjQGSAY4BkwGUAY8BlQGQAY8BlgGXAVYBOAFZAQkBCQEBAQgBEwE9ARIBjQGYAZkBAQEzAf8AhgGaAY8BmgGbAY8BjwGbAZUBmAGcAZUBCwE4AQkBnQGcAZ4BngGcAZ8BoAGhAY0BogGgAY0BjAGjAY0BjAGkAaIBpQGDAaYBgwGJAaYBpwGoAT0BlQGcAakBnAGqAakBnQGrAZwBrAGtAZUBrQGuAZUBrwGwAZUBsAGxAZUBsgGzAZUBkAGVAbQBtQGVAbMBtAG2AZABiwG2AYoBtgG3AZEBkQG4AScBtwG5AScBQAETAboBuwGGAbwBhgGIAbwBvQGIAb4BiAGCAb4BhgG7Ab8BvwG7AcABwQHCAb8BwgHDAYQBhQGEAcMBhQHDAcQBxQHGAZoBmgHGAZsBxwHIAZsBmAHIAZkByAHJAZIBkgHJAY4BygE7AQsBywHMAc0BzgHPAdABzgHQAcwBzAHQAdEB0AHSAdEB0wHUAdAB1QHWAdcBzwHYAdAB0AHYAdMBNgHZATIB2QHaATIB2wHcAd0BNQE0Ad4BNAHaAd4B3AHfAd0B3wE2Ad0BNgHgAeEB3QHiAdsB4gE1AdsB4wHkAeUB5gHnAegB5wHpAToBOgHqAecB6QHnAesB7AHtAe4B7gHtAe8B8AHxAfIB8wH0AfUB9QH0AfYB7AHyAe0B9AH3AfYBNwE7AfgB+QH6AfsB+gH8AfsBOwH9Af4B6gE6Af8BOgE5Af8B/wE5AQACAAI3AQECNwH4AQECOwECAv0BAgL8Af0BAwLnAQQC+gHmAfwB5gHoAfwB/AHoAQUCAwIGAgcC7wHlAe4BBwIIAgMCCALnAQMC8gHJAcgB+QH7AQkCCQLyAQYC8gE7AckBCgILAgwCCgKlAaYBpwENAqYBpgENAgoCCgIOAqUBDwIQAhECEgILAhMCEwIUAhUCEgIMAgsCFgIXAhgCGAIZAhMCEwIZAhICGQEOAhoCGgIOAg8CGwIcAhICHQIeAh8CIAKnASECPwE+ASECIQI+ASICIgI8ASMCPAFAASMCHgIdAiQCJQImAh0CHQImAiQCQAEnAh8CHwInAh0CKAIpAioCKwIXAhYCGAIXAhkCtwG2AboBKQIoAkABLAIXAhwCHAIXAroBtgEcAroBLQIaAS4CLwIwAi0CGQFBATECMgIeAdUBLgIZATMCHgExAkEBHgEyAjECGQEuAhoBHgFBAR8BHgECAdUBBAHVAQIBTgHWAdUB0QHSAU4BNQHiAU4BNAIWADUCFgA2AjUCNwIWADgCOAIWADQCeQB3ADkCOQJ3ADoCOwI8Aj0CPQI8Aj4CPwIWADcCPAJqAD4CPgJqAEACQAJqAEECcABCAkMCQwJCAkQCQwJFAnAARQJGAnAARgJHAnAAOgJIAkkCSQJIAkoCSgJIAkcCPwJLAkwCSwJNAkwCTQJOAkwCTAJOAmoATgJPAmoATwJBAmoAUAJEAkICUQJSAlMCUwJSAlQCUgKAAFQCVAKAAFUCVQKAAFYCVgKAAFcCVwKAAFgCWAKAAFkCgAB/AFkCWQJ/AFoCWgJ/AFsCXAJ/AF0CfwB5AF0CXQJ5AF4CXgJ5AF8CeQA5Al8C1QEEAXsBSQFgAmECYgJjAkcBTgFjAksBSwFkAmUCZgJjAmICYwJmAksBUAFnAmMCYwJoAkcBaAJSAUcBTwFoAmkCagJrAmwCbQJuAo8BbwJwAnECcQJyAm8CbAJzAmoCdAJ1AnYCdgJ1AncCeAJ5AnoCeQJ7AnoCfAJ9An4CfwKAAn4ClAGTAYECggJuAoMCbgJtAoMCcAJvAoQChQJqAoYCagJzAoYChwJ2AogCdgJ3AogCegKAAogCiAJ3AnoCiQKKAocChgKLAoUCjAKNAoQChAKNAnACcAKNAo4CjwKQApECgwKQAoICkgKUAYECkwKUAi0CLQKUAhoBlAKAAhoBlQKWApcClQKfAZYCnwGYApYCogGlAcgBmQKWAocAmgKWApkCmwKZApwCmQKHAJ0CrgGtAZ4CmwKcAp8CnwKdAqACnQKHAKACoAKHALIBtAGzAbIBMQLrAecB8gHIARkB5wHzATECMQLzARkBoQJVATECGQHIAaUBpQEOAhkB6wExAlQBMQJVAVQB8wGiAhkB8AHyARkBtgGfAC0C1AExAqMCHAK2AS0C1QHXATICMgKjAjECGQEaAjMCMwIRAi0CEQIcAi0CpAKlAqYCpgKlAqcCpQJUAVABqAJUAaUCCgCpAqoCCgBlAKkCFgB7AaoCewF2AasCqgKsAhYArAJkABYArQKuAq8CDACUAa0CsAKQAo8CkgKtApQBXQCxApQClAKyAoACigKJArICsgKIAoACDACtAq8CrQKNAq4CrgKNAowClAIwAF0ArwJhAGAAlAKxArICkwItAp8AmAKiAcgBlgKYArMChwCfALIBtAGyAZ8AnwC2AbQBswK0AqUCpQK0AqcCswKYArUCtQKYAsgBlgKzAocABAH+AHIBcgH+AHABZwG2AmkBtgK3AmsBawG3AmUBYgH9AGEB/QCHAV0BXQGHAV4BhwFNAV4BAAAKAKoCuAKGAY8BgQFRAVMBuQJeAU0BuQKBAQAAuAIDAAEAugIDALgClAG6ArgCuQJNAUwBRAG5AkwBuQJEAVEBggGGAYEBgQG5AlEBjwGUAbgCAACGAQEAhgG4AgEAhgEAAIEBugKUAQsAlAEMAAsAuwK8Ar0CuwK9Ar4CmACaAL0CvQKaAL4CqgJ2AQAAdgFeAQAAAABeAbkCqwC/AqwA0gDTAOYAwALpAOgAwQLCAsMCrgDEAuwA7ADEAu0AxAKsAL8C7gCrAO8AqwCqAO8AnwDxAKYA8QDwAKYAxQLGAr0AvQDGAscCyALHAskCygLHAsYCywK9AMMAwwDMApgAvQDHAsMAxwLIAsMAwwDIApYAyALNApYAzgLPAtAC0QLSAtMC9gD1ANQC9wDVAvgA+gD5ANYC1gL5ANcC0gD7AOUA2AL1ANkCyQLHAtoC2wLIAtwC3ALIAskC8wDyANwC0gLRAtsC1wLdAtYC3gLVAt8C1AL1AOACTgF7AWYAZgBjAk4BewFOAdUB2AHPAaECMQLUAaECzwHOAaECNgFYAVUBoQI2AVUBvgGCAeEC4QKCAeIC4wLkAoIB5ALlAoIB5gLjAoIB5gKCAecCggGoAucClwGWAesBlwHrAagC6ALpApYBOgHpAZYB6gKlAusCvgHhAuwC7QLuAu8C7wLuAuUC7wLlAvACpQKkAusC7wLwAvEC8QLwAvIC8wL0AvUCqALrAVQBqAKlAuoC6gL2AqgCvAH3AvgC+QL6AvsC+wL6AvwCuwG8Af0CvAH4Av0C+wL8ArQCtQLIAcQB/gL/AgADxgHEAcgBwAEBA/4CAQMCA/4C/gICA/8CMQEDA3ECcQIDA3ICKAEEA3ICKgEwAWsCawIwAWwCLgF1Ai8BdQJ0Ai8BfQJ8AiIBIgF7AiMBewJ5AiMBIgEaAYACfwIiAYACAwC6AgsAUAFjAmYAhQCzAo4AswKlAo4ApQJmAI4ApQJQAWYAewEWAGYAzwLOAoIABQPPAoIAkwIGA80C8QCfAIkAnwCHAIkABwN0AHMAhQB0AAcDBwOzAoUAkwKfAJ4AggAwAAUDMADNAgUDBwNzALMCswJzAIcAMACUAs0ClAKTAs0CDgAyADMAMwAyADAAEQA0ADMAEQAIAzUACAMJAzUANgA1AAkDCgMJAzoACwM6AAwDDAM6AAkDDQMLAwwDDgMPAwwDDwMNAwwDDgMQAw8DDwMQAxEDPAA7ABADOwARAxADPgA8AD8APwBEAEAARABCAEAARAASA0MAFQBBAEMAFgBHAEYADAN8AH0AfAAMA3sARgBFABYAFgBDAIAAQwASA4AAEgNEAIAARAA/AIAAPAAQA30AfQAQAwwDEAMOAwwDDAMJA3sAewAJA34ACQMIA34ACAMRAH4AfgARADAAEQAzADAAgAA/ADwAPAB9AIAAdgB+ADAA9ACCAM4C9ADnAIIAbQDnAIsA5wDrAIsA6wDxAIsAiwDxAIkAbQCLAGsAEwM7Aj0CFANPAhUDFQMWAxQDFwMYAxkDGgMbA0sCHAMdAx4DHQMfAx4DGgMWAxsDFgMVAxsDIAMhAyIDGAMXAyMDJAMlAyYDTwIcA0ECHAMeAycDPgIoAz0CKAMmAz0CJgMTAz0CKQM/AioDPwIpAysDLAMtAy4DLgMtAy8DMAMxAzIDPwIrA0sCMwMuAzQDLgMvAzQDNQM2AzcDOAM5AzUDOgM2AzUDOwM8Az0DPQM8Az4DPwNAA0EDOwITA0IDQgMlAyQDQgNDAzsCQwM3AzsCQwNEAzcDPQM+A0QDRAM1AzcDRQNGA0cDSANJA0oDUQJLA1ICUgJIAzYCSAM1AjYCNwIqAz8CMQMwA0wDMANNA0wDTQNOA0wDSANKA0UDTQNPA04DTwNQA04DTgNQA1EDUAM1AlEDSwNSA1MDPAM7A1QDNgM6A1UDVgNXA1gDWQNaA1sDWgNcA10DXgNfA2ADYQNiA2MDRgJkA0cCYgNHA0YDVANlA2YDZwNoA2kDZgNqA2sDagNsA2sDbANtA2sDbgNvA3ADbwNxA3ADcgNzA3QDdANzA3UDcwN2A3UDdgM6AnUDOgJ3AzkCdwN4AzkCXQN5AzkCegN7A3wDfAN7A1wCewN9A1wCXAJ9A34DfQN/A34DWQKAA4EDgANnA4EDggODA2kDUwKEA4UDhANKA4UDaQOGA2cDhgNYAmcDeQNfAjkCdAOHA3IDhwNHAnIDcgNHAogDiANGAnEDRgJFAnEDcANDAm4DVAM5AzgDUwJTA1IDVQOJAzYDiQNQAjYDSQJ1AzoCTAJqAGYAPwJmABYAZgA/AkwCfwB9AHkAdwB2AEgCdgB1AEgCigN1AHAAbgBsAIsDiwNsADcDjAM7AnMAbABzADcDNwNzADsCdwBIAjoCRwJIAnAANgNQAkICPAI7Ao0DcwBpAIwDQgKOAzYDiwM3A24AUgI2AoAAgAA2AhYA5ACyAI8D0gDkAJAD5ACPA5ADkQPLAJIDywDKAJIDkwOUA5UDzgDNAJYDlwPXAJgD1wDWAJgD0gCQA9AAkAOZA9AAvQK8ApoDtgC3AJsDtACzAJwDnAOzAJ0DugC8AJ4DnwO+AKADvgDAAKADyQDIAKEDoQPIAKIDowO9ApoDpANiA6UDpQNiA6YDYgNhA6YDYAOmA2gDYQODA6YDgwNoA6YDaANeA2ADYANfA6cDpwNfA1kCWQKoA6cDqAOpA6cDpwOpA6oDqQN6A6oDegN8A6oDXQNcA6sDfAN5A6oDeQNdA6oDqgNdA6sDrANzA60DqwNZA64DWQNbA64DWwOsA64DrgOsA60DcwOvA60DrwOIA60DiANYA60DWANXA60DrQNXA7ADsAOxA7IDsQNWA7IDsgNWA24DbgNDArIDsgNDArMDQwJtA7MDbQO0A7MDtANlA7MDswNlA7UDZQNUA7UDVAM/A7UDtgO3AzEDuAO3A7kDuQO3A7YDNQK6A7gDuAO6A7cDuwO6AzUCNQJIA7wDNQK8A7sDuwO8A7oDvQO8A0gDpQO8A6QDpAO8A70DMgMxA7cDtwMWAzIDMgMWAxoDIAMUAyEDIQMUAxgDGQMYAxQDFAO+AxkDGQO+A78DQQPAAz8DwAO1Az8DRAPBA8ADvwO+A8EDvgPAA8ED",count:1022},{rgb:[1,1,1],positions:"ugFI/2T+pgFI/3j+2gFM/4L99wFI/6P8BwJI/6P8MAJI/xT+3wFI/0f+KwJI/zH9XAJJ/wD+VAJJ/4X9iAJI/+/95gEGADP+UwIHAGj9GwIFAIX8xAIBANr9JgLp/4b8BAJZ/4f8tgFk/2n+MAJJ/xX+JQKF/8z8CAJJ/6P8oAJc/9n9ZAJy/4j9pgFJ/3n+pgFJ/3r+iAJJ//D9pgFI/3j+ugFI/2T+pgFJ/3n+pgFJ/3r+vAFK/2b+4AFK/0j+4AFK/0j+vAFK/2b+4AFJ/0j+4AFJ/0j+3wFI/0f+CAJK/y3+CAJK/y3+CAJJ/yz+CAJJ/yz+MAJI/xT+MAJJ/xX+iAJI/+/9igJJ/9X9igJJ/9X9bQJJ/679iQJI/9b9bQJJ/679VAJJ/4X9KwJI/zH9iQJI/9b9DwJl/4b8JgLp/4b8mQBI/5D/ZwBN/4P/ZwBP/3L/0gBI/7X/pABK/2T/+gBI/9X/5wBI/83/0gBI/7X/GQFJ/1r/GAFI/1n/LwFJ/yL/MAFJ/yL/MAFJ/yL/HwFK/0r/MAFK/yL/LQFI/yP/LwFJ/yL/HQFI/0n/LQFI/yP/HQFI/0n/GQFM/zH/GQFJ/1r/BgFI/5f/HwFK/0r/HgEAAFX/BgFI/5f/AAFK/8X/AAFK/8X/vwAEANT/WgD6/5v/WwCz/5f/WwCz/5f/WwAGAJP/WgBf/4T/7gDD//T/7QAGAPj//AAGAO3/GAFI/1n/CQEGAJX//AAGAO3/WgBl/37/MAFK/yL/4QD4AXX+6AEaAkj+kwLoAQn+2gARAhD/6wDnARP+lQC4AST/PQC8AbH+Rf+YAeb+AgEHADcAUAEHABsByQAMANL/bQFlAtkAUgGfAfoAwQAvAaf/sf/IAHD/bAAKAKP/gABrAUL/IQB/ARX/JgNPAhz+uQJ0At8BUQIJAEACdAR0AmIBSwQYABQCngUgAP3/IwV0AuT/UwR0Anz+7QMsAQT+UwQHABD+UAUJAG//JQIDAGz7IwIH/0f7GAKlAFL75AET/5b8IAK0/9z7JQIIAAb8JQFz/jP+h/7uAA3/igBGAlT7ef67AY37n/3D/1H7g//E/Uv7O/9M/r7+TQEE/+j+gwCO/hn/kv8xATX/+f7E/1v/oP5W/yn/+f8FAJf/MgAf/2n/l/9+AIP/Xf9x/3T/+QDcAXP9GAHOAdn8DwNhAfr9ggHWAdH9lgGZAWb9zgIlAMb9egIHAJz9MAIJANb85QFQAT/9RgNsA1v+ZwM/A07+AQNSA1P+OwNTBFkA1wNFBKX/9wJXBPb/4wIvBPYAeAJBBDkAFgQ1BJoAhwJSBO7/MgM0BC3/RgLtAyj/9QHuA7n/5gHtAxQA6gHtA0oAAwLtA50AIgQbBJ8AdgTtA4gAIQLtA9MARwLtAwABjwLtAzkB6wLtA10BLwPtA2YBewPtA2AB1QPtA0ABJgTtAwUBiwTtA/T/dwTtA6L/igTtAzYATATtA07/AQTtAwL/uQPtA9z+dQPtA8b+3QLtA83+nQLtA+f+",indices:"AAABAAIAAgADAAQABQAGAAIABAAHAAIAAgAHAAgABwAJAAgACAAJAAoABQACAAgAAAACAAYACwAMAA0ACwAOAAwADwAQAA0ACwARAAgAEQASAAgADgALAAgAEwAUABAAFQAWAAwAFgATAAwAFwAYABEAAQAXAAIACAAZAA4ADgAVAAwAGQAVAA4AGgAbABwAGwAdABcAEQAYAB4AEQAeAB8AIAAhACIAIQAdACIAHQAbACMAIwAbACQAEgARACUAEQAfACUAJgAgACcAIAAiACcAKAAjAAYABgApACgAKQAqACgAJwASACYAKgApAAgAGQAIACsALAAVAAoAFQAZAAoAFQAtAC4ALAAvADAAFgAVADEAFQAuADEAEwAWADIAFgAxADIAEwAyABQAFAAyAAQALAAKADMACQAwAAoAMAAvAAoAEAAUAAMAAwAUAAQAEwAQADQADwATADQADQAMADUANQAMABMAEAAPADQANgA3ADgAOQA2ADoANgA4ADoAOwA8AD0APgA/AEAAQABBAD4APgBCAEMAQgBEAEMARQBGAD8APwBHAEgASABJAEoAPwBLAEwAPgBNAEwATABNAE4AOwBPAFAATABOAFEAUQBOADsAUgBTAFQAVQBTAFYAVgBXAFUAVwBSAFQAVwA3AFIAOwBSADwAUgA7AFgAUgBYAFkAWAA7AFkAWQA7AFoAOQA6AFsAOgBKAFsAWwBKAEkAWwBPADkATwA7ADkARgBIAEoARgBEAEIAVgBSAE4ATgBSAFwAUgBdAFwAXQBSAFkAVgBeAFcAOAA3AFcAOABXAF4AUgA3ADYAUwBSAFYAUgA9ADwAUgA2AD0AXwBOAE0AOwBcAF0ATgBcADsAYABhAGIAYABjAGEAYgBkAGAAZQBgAGYAYwBgAGUAYABkAGYAZgBkAGcAaABpAGoAawBjAGUAaQBsAG0AbQBsAGUAZQBsAGsAbgBvAGoAagBpAG0AcABlAGYAcQBqAHAAcABqAG0AbQBlAHAAYgBhAHIAcwB0AHUAdAB2AHUAdwB1AHYAdwB4AHUAdwB5AHgAegB5AHcAYgB5AHoAeQBiAHIAdABsAGkAdABzAGsAbAB0AGsAegB3AHsAewB3AHwAfQB+AH8AAwACAIAAgQADAIAAgQAQAAMAggANAIEADQAQAIEAfwCCAH0AggCBAH0AfQCBAH4AgQCAAH4AAgAXAIMAhABnAIUAhACFAIYAhwCEAIYAiACJAIcAfgCDAIgAgwCJAIgAAgCDAIAAgwB+AIAAhQB/AH4AhwCGAH4AfgCGAIUAfgCIAIcACwCKABEATgCKAAsAFwARAIoAiwCKAEoASgCKAEYARgCKAF8AgwAXAIoAZwBxAGYAcABmAHEAcQBnAIwAjQCEAI4AjgCEAIcAjgCHAIkAjgCJAIsAgwCLAIkAigCLAIMATgBfAIoAXgBWAI8AkAA4AF4AOgA4AIsAZwBuAIwAjABuAHEAbgBnAJEAZwCEAJEAjgCSAI0AkgCOAIsAkACLADgAOgCLAEoAkACSAIsAcQBuAGoAkABeAJIAjwCEAJIAkgCEAI0AkQBvAG4AXgCPAJIAjwCRAIQAkQCPAG8AZACFAGcAkwCUAIUAewCVAHoAZABiAJYAlwB/AJQAfwCFAJQAewCYAJUAmQCaAJgAmACaAJsAmgCCAJsAggB/AJsAmwB/AJcAhQBkAJMAZACWAJMAkwCWAJcAlgBiAJcAlwCYAJsAkwCXAJQAlwBiAJgAmABiAJUAYgB6AJUAVgBvAI8ATgBqAFYAagBvAFYATgBoAGoACwCZAJgADQCaAAsAmgCZAAsADQCCAJoAdABpAHsAewB8AHQAdAB8AHcAdwB2AHQAewBpAJgAaQBoAJgAmABoAE4ATgALAJgAnACdAJ4AnwCgAKEAogChAKMApACfAKIAnwChAKIAowChAKUAoQCmAKUApgChAKAAoACfAKQApQCnAKgAqACpAKUAqQCqAKUAqgCrAKUApACsAK0ApQCrAK4ApQCuAKMArgCvAKMAowCvAKIAogCvALAAsACxAKIAsQCyAKIAsgCzAKIAswC0AKIAogC0AKQApAC0ALUApAC1AKwAtQCtAKwApAC2ALcArQC4AKQApAC4ALYApAC3AKAAtwC5AKAAuQC6AKAAugC7AKAAoAC7AKYAuwC8AKYAvAC9AKYApQCmAL4ApgC9AL4ApQC+AKcA",count:278}],link4:[{rgb:[.039,.051,.055],positions:"cwFzAX0CEQLu/3MCD/6BARECiQAH/nICqP5x/n0Cbv2oACICogDyAX8Chv7nAQkCJgGZAWYDSwGeAYYC6gHLAIcCrgFGAdoCAQKHAIcCCQJkAIcC6gHLAIcCDgJAAIcCEQIdAIcCEQIdAIcCEALV/4gCEALV/4cCBgKO/4cCEALV/4cCBgKO/4cC8gFJ/4cC1QEI/4cCrwHL/ocCgQGU/oYCEgE6/ocC0gAZ/ocCjgAB/ocCSADz/YcCAQDu/YcC3f/v/YcCuf/y/YcClv/4/YcCc/8B/ocCc/8C/oUCUf8L/ocCL/8Z/oUC0f5N/oUC8P46/oUC8P45/ocCtP5i/oYCtf5i/ocCtP5i/oYCL/8Z/oUCc/8C/oUC8P46/oUC0f5N/oUCtwEpAYcC2wHrAIcCEQIdAIgCDgJAAIcCCQJkAIcCgQGU/ocCaAFy/pECTQFj/ocCEgE6/ocCHgFV/uwC0gAZ/ocCSADz/YcCn//t/ZICAQDu/YcC3f/v/YcCuf/y/YcClv/4/YcCUf8L/ocCOf8U/ooCc/8B/ocCp/7G/r4Dtf5i/ocC2wHrAIcCtwEpAYcCSwGeAYUCTQFj/ocCgQGU/oYCgQGU/ocCGQHBAYUCGQHBAYUCGQHCAYYCGQHCAYYC5ADgAYYCSwGeAYYCSwGeAYUCSwGeAYUC5ADgAYYChP6O/oYChP6O/oYCWf6+/oYCWf6+/oYC1P/oAXgDSgCPAdgDKQDeAX0D9AAUAfQDzAA5AfID2v90AfIDMgByAfIDEP+8AY4Dj/9kAfIDXv5PAWoDX/5OAWsDV/6cAMcDaQFfAPIDdgEIAPIDkQGBAM8DzgFlAJgDzAEKAKkDwwGv/6wDcAG+//IDcAG+//IDWwHR/r4DJQER//EDFgAy/soDPgHEAPID2QHo/4wDswFz/60DbQDNAYEDKQDeAX0Dof6TAWsDXv5OAWoDX/5OAWsDa//nAXIDn//qAXUDFP8lAt4C1P/pAXcDn//qAXUDa//nAXIDL/4JAWoDXv5OAWoDXv5OAWoDXv5PAWoDXv5PAWkDAAD6AT4DQgDuAT8DQgDuAT4DAAD7AT0Dvf8CAj0DAAD7AT4Dvf8CAj0Dvf8BAj4DQgDvAT4DQwDvAT0DAAD7AT0DQgDvAT4DQgDuAT4DAAD7AT4Dvf8BAj4Dvf8BAj4Dvf8AAj4DQgDvAT4DvP8AAj4Dvf8AAj4DvP8BAj4Dvf8BAj4DdP8nAt0Cuv8AAkEDu/8AAj8Du/8AAkEDu/8AAkADu///AUEDu///AUADRADrAUIDRADrAUEDQwDLAUIDRADrAUEDRADsAUEDQwDLAUIDRADrAUEDQwDLAUEDRADsAUEDQwDLAUEDRADsAUADQwDLAUEDRADsAUADQwDLAUADQwDLAUADRADsAUADQgDLAUADQwDtAT8DQwDtAT8DQgDMAUADQwDuAT8DQwDtAT8DQgDMAUADQgDLAUADQgDuAT8DQQDMAT8DQwDtAT8DQQDMAT8DQgDMAUADvf/LAUADvv/MAT8Dvf/lAT8Dvf/LAUEDvf/LAUADvP/lAUADvf/LAUIDvP/lAUED6v+6AX4Du//+AUEDu//+AUEDvP/lAUEDu///AUADvf/LAUIDvf/LAUEDvP/lAUEDvP/lAUADu///AUADu/8AAj8Dvf/LAUADvP/lAUADvP8AAj4Dvf/lAT8DvP8BAj4Dvv/lAT8Dvf/lAT8Dvv/MAT8DMwDkAV8DMQDDAWIDMwDkAV8D2v/nAXcDEgDiAXoD2v/nAXcD2v/pAXcD2v/oAXcD2v/oAXcD2f/oAXcD2f/oAXcD2P/pAXcD2P/pAXcD1//pAXcDJQDfAXwDJADfAXwDIwDfAXsDJADfAXwDJADeAXwDJADeAXwDIwDeAXwDIwDeAXwDIwDeAXwDIwDdAXsDIwDdAXsDZ/1fAIUCZf1eAIUCVP2NAIUCUf2lAIUCVP2NAIUCUP2lAIYCUP2lAIYCT/2lAIcCUP2iAKQCT/2lAIcCZP1dAIcCY/1dAIkCZf1eAIUCUf2/AIgCUf2/AIgCUv2+AIYCUv2+AIYCU/2+AIUCUf2lAIUCU/2+AIUCVP2+AIUCef2sAIUCu/15AYUC+v38AYUCEf7kAYUCef2sAIUCVP2+AIUCe/1LAYkCsP51AogCsP50AoYCbv5UAoYCMf4sAoYCbv5UAoYC+v38AYUCsP50AoYCsP5zAoUCsP5zAoUCsf5xAoUCQf4ZAsMCjv5mAosCMP4tAokCbf5VAokCjv5mAosCsP51AogCsP51AogCMP4tAokCMf4sAoYCyP58AocC4P5/ApkCbf5VAokCx/3IAYoCYf0GAYkCnf2MAYoCx/3HAYsCx/3IAYoCYv0GAYcCYv0GAYcCYf0GAYkCe/1LAYoCnf2MAYoCe/1LAYkCnf2MAYkCnf2MAYkCe/1LAYoCjf1AAb8CyP56AoUCy/5SAoUCsf5xAoUCyP56AoUCyP57AoYC4f59AoUCBv96AoYCEv92AoUC4f5+AoYCBv97AocCE/94AogCGAAnApAC4f59AoUCBv97AocC4f5+AoYCyP57AoYCyP58AocCE/94AogCEv93AocCEv93AocCBv96AoYCEv92AoYCEv92AoYClP3iAMACiv2oAMECkv0qAYUCpf0aAcEClP3iAMAC8/2lAcAC8/2lAcAC0f10AcECGv7QAcECnP4sAsACU/4cAoUCaP4OAsEC1f5DAsICnP4sAsACrv2AAb8C1/27Ab0Cx/3HAYsC1/27Ab0CpP2VAMYCp/2XAMgClv2pAIACrv2dAMsCrv2dAMwCr/2hAM0Crv2dAMsCq/2ZAMoClv2pAIACp/2XAMgCpP2VAMYCo/2VAMYCo/2VAMYCjv2bAMECjv2bAMECiv2oAMECtf0lAYUCuP3XAM0CyP0MAc0CuP3XAM0Cxv0aAcgCxv0aAcgCr/0wAYUCtP0lAcECr/0wAYUCrP0yAYUCrP0yAYUCpv01AYUCsf0lAcACpv01AYUCsf0lAcACrv0kAcACrv0kAcACjv0cAIUCjf0bAIUCgv0wAIUCgf0vAIUCgf0vAIUCjf0bAIUCgf0vAIYCjf0bAIUCjP0bAIYCgf0vAIYCjP0aAIcCgP0uAIcCjP0bAIYCgP0vAIYCjP0bAIYCgP0vAIYCi/0aAIgCi/0aAIkCf/0uAIkCgP0uAIcCi/0aAIgCf/0uAIgCf/0uAIgCf/0uAIkCf/0uAIoCf/0uAIkCi/0aAIoCi/0aAIkCqP3m/4gC2/2w/74Ci/0aAIoClv0PAIQCmv0BAIYCmv0BAIYCmv0BAIcCjP0aAIcCmv0BAIcCqP3m/4gCi/0aAIkCov30/4UCuP3M/4QCqf3n/4UCt/3M/4UCx/2y/4UCuP3M/4QCqv3n/4QCqf3n/4UCqf3m/4YCm/0CAIUCxv2y/4YCt/3M/4UCx/2y/4UCqf3m/4YCqP3m/4cCxv2y/4YCm/0CAIUCov30/4UCqv3n/4QCY/1dAIsCb/1sAL0CU/4cAoUCTv4TAoUCzf0aAX0Cyv1oAYUCI/7IAYUCJv7SAYUCKv6FAYQC/f2dAYUCZ/1fAIUCjv0cAIUCTv4TAoUCU/4CAoUCEf7kAYUCy/85AoUC1f41AoUCGP7kAYUCBQAoAoUCHAAMAoACvf1yAYUCyv1oAYUCu/15AYUCvf1yAYUCIf7fAYUCGP7kAYUCJv7SAYUCYP79AYUCIf7fAYUCU/4CAoUCYP79AYUCfv7vAc0Cev7tAcwCcP7uAcgCaf7yAcQCaf7yAcQCYf79AcECYf79AcECZP4KAsACZv4NAsACZv4NAsACrv4KAs0C4f4fAswCrv4KAs0C4f4fAswC4/4gAswC5f4iAssC5f4iAssC5v4jAssC5v4jAssC6P4lAsoC6P4lAsoC6v4sAsYC6v4wAsUC6v4wAsUC4f5AAsEC4f5AAsEC4P5BAsEC4P5BAsEC3f5CAsEC3f5CAsECNf61AcwCEP6NAcsCEP6NAcsC8f1gAcwCI/7IAYUCOP65AcsCOP65AcsCOf6+AcoCOf7CAcgCOf7CAcgCNf7NAcMCNf7NAcMCMP7SAcECMP7SAcECI/7VAcACI/7VAcACiP2oAMMCif2oAMMCk/3iAMMCpP0aAcIClP3iAMICpf0aAcICpP0aAcICpP0bAcMCk/3iAMMCiv2oAMICif2oAMMCpP0bAcMCpP0cAcMCkv3iAMMCaf2LAMICiP2oAMMCkv3iAMMCpP0cAcMCnP3+AMEClP3iAMECjv3FAMEClP3iAMEClP3iAMICjv3FAMECnP3+AMECpf0aAcECpf0aAcIClP3iAMICiv2oAMICz/1xAcAC0P11AcMCzv1yAcMC0P11AcIC0f10AcIC0f10AcEC0f10AcICzv1yAcMC0P11AcMC8v2lAcMCGv7RAcIC8v2lAcICGv7QAcICGv7RAcIC8v2lAcMC0P11AcMC8f2mAcMCGf7RAcMCGv7RAcMCGv7RAcMCGv7QAcIC8/2lAcICGv7QAcEC8/2kAcECIP7VAcMCBv67AcECGv7QAcEC4f2NAcEC8/2kAcECBv67AcECGv7QAcEC4f2NAcEC8/2lAcICGv7QAcIC8v2lAcIC0P11AcICaP4PAsECaP4PAsICaP4OAsECaP4PAsICm/4tAsMCnP4sAsIC0v5CAsIC0v5DAsMCm/4tAsMC0v5DAsMCnP4sAsICt/43AsECaP4PAsECgv4eAsEC1f5DAsICt/43AsECgv4eAsEC0v5CAsIC3f5CAsEC8v5oAsICvv5eAsIClv08AcMCjv2OAMYC9P4q//MDGP8A//UDRf/g/vMD3/+L/vUDvP6J//UDvf6J//QDVwHg//QDTQFTAPMDIf8HAfQDLv8yAfQDB//vAPUD1f7aAPQD5P7EAPUDqv7c//QDk/7h//UDs/6l//UD0v6kAPQDwf6DAPUDn/54APQDrAAqAfQDjAA7AfQD0QASAfQD7AD6APQDGgHtAPQDBQHgAPQDGwHDAPQDVwGTAPIDQQF9APQDMgGeAPQDp/4EAPQDG/4XAJgDrP41APQDtP5YAPQDagBIAfQDZwBkAfQDqf+y/vUD3/+o/vUDJACq/vQDVwCz/vQD4QDX/vMDmwDM/vQDoQDQ/vQD/gAV//UDEwEz//MDKAFR//QDOwF4//MDSQGZ//QDUgG8//QDrv2WAMwCr/2hAM0Crv2dAMwCq/2ZAMoCo/2VAMYCp/2XAMgCp/2XAMgCyP0MAc0Cuf3XAM0Cuf3XAM0C9/1X/4UC6/1u/4UC9/1X/4UC6/1u/4UCY/1dAIsCBgAqAoYCzP87AoYCzP88AocCBQApAoUCBQAoAoUCBgAqAoYCBQApAoUCy/85AoUCzP87AoYCBgArAocCzP88AocCzP88AogCBgArAocCBgAsAogCBgAsAogCzP88AogCBgAsAokCzP88AokCzP88AokCzP88AooCBgAsAokCDAAnAoUCDAAnAoUCDAAoAoUCDAAoAoUCDAApAoYCDAApAoYCDAAqAocCDAAqAocCLAAjAogCLAAjAogCKwAiAoYCQwAbAoUCKwAhAoUCKwAhAoUCKwAgAoUCDAAoAoUCKwAgAoUCKwAgAoUCkf80AsYCbf7kAc4Cfv7vAc0Crv4KAs0Cev7vAdMC4f4fAswCrv4KAs0C4f4fAs0C4f4fAs0C5f4iAswC5f4iAswC6P4lAsoC4/4gAswC5f4iAswC0f1hAcEC0v5DAsMC8f2mAcMCGf7RAcMCkv3iAMMCm/4tAsMC8f1gAcwC7/1TAdECEf6NAcwC4f1ZAcYCPf7i/oYCJP4I/4YCDP4v/4UCJP4I/4YCDP4v/4UCPf7i/oYCWwAVAoUCQwAbAoUCigAGAoUCigAGAoUCKwAiAoYCWwAVAoUCNf61AcwCOf6+AcoCi/0aAIoCY/1dAIsCf/0uAIoCY/1dAIkCgv0wAIUCVf/yAXwCmf2YAHcCDAAEAmYCQQDMAT8Dvv/lAT8Dvv/MAT8Dvf8AAj4DAAD6AT4Du//+AUED2v/nAXcDu///AUEDu///AUEDuv8AAkIDu/8AAkEDuv8AAkIDRADtAUIDRgDtAUIDRQDtAUMDRADrAUIDRADsAUIDRADrAUEDQwDtAT8DQgDuAT4DNQDmAWADNADmAWADJQDfAXwDNADmAWADMwDmAV8DNADmAWADMwDmAV8DMwDlAV8DMwDlAV8DRADrAUIDRQDtAUMDNADmAWADNQDmAWADRgDtAUIDRQDtAUMDRADsAUIDRADsAUIDRADtAUIDpf0aAcICz/1xAcAC7/1eAcwC6/1bAcoC7/1eAcwC6f1aAcoC6/1bAcoC5f1ZAcgC4/1ZAcYC6f1aAcoC7v1cAcwC7v1cAcsC8f1gAcwC7v1cAcsC6f1aAcoC7v1cAcwC6f1aAcoC5f1ZAcgC4/1ZAcYC4f1ZAcYC6f1aAcoC5f1ZAcgC8f1gAcwCEP6NAcwCEP6NAcwCEf6NAcwCOP65AcwCOP65AcwCNf61AcwCEv92AoUCzP88AooCXv5PAWkDNQDmAWADJQDfAXwDvf8CAj0Dvf8CAj0DAQJBAPYCEQIdAIgC3QFx/0ID8gFJ/4cCygEU/+IC1QEI/4cCrwHL/ocCogHS/uUCsQAY/tECjgAB/ocCZgAG/t8CCf84/tUCqP4AAPQDqf4AAPMDqP4AAPQDtP5YAPQD0v6kAPQDwv6DAPQDrf41APMDrP41APQD/P7gAPQD5f7DAPQDIv8FAfMDCP/uAPQDIv8GAfQDCP/uAPQDIv8GAfQDIf8HAfQDwv6DAPQDwf6DAPUD5f7DAPQD5P7EAPUD/P7gAPQDB//vAPUDtP6m//QDr/64//QDs/6l//UDtP6m//QDtf6m//MDr/64//QDqv7c//QDq/7c//MDq/7c//MDAABYAfQDj/9kAfIDxP9RAfIDAABXAfMDAABYAfQDU/8oAfIDxP9OAe0Dov9LAfQDov9LAfQDvP6J//UDAACo/vQD3/+o/vUDAACo/vQDAACp/vMDvv6J//MDvf6J//QDqf+z/vQDqf+0/vMDGP8A//UDGf8B//QDqf+y/vUDqf+z/vQDHABWAfMDHABXAfQD7AD6APQDygAVAfMDvQAZAe0DGwHDAPQDJgGjAO0DMQGeAPMDVwC0/vMDJACr/vMDMwCt/vMDWAEMAPQDVwHo//QDAACp/vMDHABXAfQDQABRAfMDQABSAfQDjAA7AfQDrAApAfMDrAAqAfQDygAVAfMDMQGeAPMDMgGeAPQDSwFaAPMDQQF9APQDVAEwAPMDVwEMAPMDWAEMAPQDVgHo//MDVwHo//QDVgHo//MDUgG8//QDJwFR//MDKAFR//QD/AAX//MD+AAR//QD3QD5/vMDoQDR/vMDeQC//vMDegC+/vQDVwC0/vMDVwCz/vQDMwCt/vMDJACr/vMD/QAW//QDQABSAfQD/QAW//QD+AAR//QDegC+/vQDVwGTAPIDGgHtAPQDzAA5AfIDMQBtAfQDMgByAfIDaQFfAPIDPgHEAPIDQgDEAUADIgCzAXgDv//FAT4Dvv/FAT4Dvv/FAT4Dvf/LAUADvv/EAT8Dvv/EAT8Dvv/EAT8Dvv/EAUADvv/EAUADv//FAT4DQgDEAUADQgDEAUADQgDEAT8DQgDEAT8DQgDFAT8DQgDFAT8DQQDFAT4DQQDFAT4DQQDFAT4DQADFAT4DQADFAT4DEQCu/u0DbgDB/u0DvgDn/u0DeQC//vMD3QD5/vMDBQEp/+0D/AAX//MDEwEz//MDJwFR//MDPQGQ/+0DSQGZ//QDVwEMAPMDUwH3/+0DTQFTAPMDVAEwAPMDTwEzAO0DBQHgAPQD7AD0AO0DrAApAfMDaABBAe0DQABRAfMDFABTAe0DHABWAfMDAABXAfMDvv6J//MD1f5q/+0D9P4q//MDGf8B//QDI////u0DRf/g/vMDqf+0/vMDmv+//u0Drf72/+0Dqf4AAPMDwP5mAO4Drf41APMDIv8FAfMDQf8YAe0DxP9RAfID",indices:"AAABAAIAAQADAAIAAwAEAAIABAAFAAIABgACAAcAAAACAAYACAAAAAkACgALAAwADQAOAAwADQAPABAAEQASABMAEgAUABMAEAAVAAEAFQAWAAEAFgAXAAEAFwAYAAEAGAAZAAEAAQAZABoAGwAcAAMAHAAdAAMAHQAeAAMAHgAfAAMAHwAgAAMAAwAgACEAIgAjACQAIwAlACQAJAAlACYAJwAoACkAJwApACoAKQArACwALQAEAC4ALwAwAAQAKgAEADAAMQALADIAMwA0ADUANAAzABEAEQAzABIANgA3ADgANwA5ADgAOQA6ADsAPAA9AD4APgA9AD8AQAA/AEEAPwA9AEEAJgBCAEMAQwBCAEQAQwApACYAKQBFAEYACwAKADIARwAAAEgAAABJAAkAAABHAAEAAQBHAA4ADgANAAEASgADABoALgADACEAAwBKABsAAQANABAABAAtAC8ALgAhACIALwAmACkASgBLAEwASwAZAEwAAwAuAAQABgBNAAAATgBPAAkACQBQAAgAUABRAAgAUgBTAE4AVAAAAE0ATgBVAE8AVgAEACoAVwBGAEUARQBYAFcALAArAFcAWQAEAFYAWgBbAFwAXQAIAF4AWwBeAAgAWwBfAGAAYQBiAF8AYwBkAGEAZABlAGEAYQBfAFsAZgBnAGgAaABnAGkAaQBnAGoAagBnAGsAZwBsAGsAawBtAG4AbgBvAHAAaQALAGgACwBxAGgAcQALAAgAagBrAGkAawByAGkAawBuAHMAawBzAHIAdABbAAgAdAAIAHUAXABbAHQAYQB2AGMAdwB4AGMAeQB6AHsAeQB7AGEAWwBaAGEAewB6AHwAWgB8AHoAYQB9AH4AYQBaAH0AZQBkAH8AZACAAH8AgQCCAH8AfwCCAIMAhACFAIYAhwCIAIkAiQCKAIsAjACNAI4AiQCPAIcAkACRAIQAhACRAJIAhACTAJQAkACVAJEAlgCXAJgAmACXAJkAmgCbAJgAigCYAIsAmACbAJwAmwCdAJwAnACdAJ4AnQCfAJ4AngCfAKAAoQCiAKMApAClAKYApQCnAKYApgCnAKgApwCpAKoAqQCrAKoArACtAK4ArwCwALEAsACyALEAswC0ALUAtgC3ALgAtgC1ALQAuQC6ALsAuwC8AL0AvgC/AMAAwQDCAMMAxADFAMYAxQDHAMYAyADJAJ8AygCfAMkAywDMAM0AzADOAM0AzQDOAM8AzwDDAJ4AwwDQAJ4AwADQANEA0QDQANIAmADTANQA0wDVAMAAwADVANAA1gCXANcAlwCWANcAlgCYANQA1gDXANgAoQCjANkAowDaANkA2gDGANsAxgDcAN0A3QDeAN8A3gDgAN8A4QDiAN8A4wDkAN8A3wDlAOYA5wDoAOkA6gDrAOkA7ADtAOkA6QDuAN0A3QDvAPAA3QDxAMYA8gDzAPQA9QD2APcA+AD2APkA9gD6APsA/AD9AP4A/wD7APoAAAEBAfkA+QABAfgA9wACAfUAAgEDAfUABAEFAQYBBwH0AAQB8wD9APYA9gD9APoACAEJAQoBCwEMAQ0BDgEPARABEQESARMBFAEVARIBEgEWARcBGAEZARoBGwEcAR0BEAEbAR4BHwEbASABGwEQASABHAEhAR0BIgEhARkBGQEjARoBGgEJASQBHwEgAQkBJQH/APoAJgEnASgBBgEFAQ0BDQEDASkBAwECASkBAQEAASoBKgEAASsBLAEtAS4BLQEvAS4BDQEwAQgBKgErAQ0BLgElASwBJQH6ADEBMQH6ADIBLQEkAS8BJAEJATABMAEJAQgBMwE0ATUBNgEVATcBFQEUATcBFwEWATMBOAE5AToBOwEiATwBIgE9ATwBPQEiAT4BOQE/AUABPwFBAUABQgEPAUMBDwEOASEBIQEiATsBRAFFATwBQAFGAUcBRgFIAUcBOQFJAToBNAEzATgBPwE2AUEBNgE3AUEBQgFDATsBSgFLAQsBTAFNAQsBTQFOAQsBCgFPAQgBUAFRAQgBUgFPAQoBNAFTAVQBUwFVAVQBVgFXATQBMQEyASYBMgFYASYBJgFYAScBWAFZAScBWgFbASgBKAFZARoBWQEYARoBXAFdAV4BXwFgAV4BYAFhAV4BYgFeAWMBYwFkAWUBZgFeAWcBXgEHAWgBaQFoAQcBagELAWsBbAFeAWEBbQFuAWwBbwFsAWEBbgFwAWwBcQFyAWwBcQFzAXQBdAFzAXUBdgFzAXcBcwF4AXkBegF7AXkBfAFNAXkBeQFNAUwBAgAFAAcAfQF+AX8BfwF+AYABgQGCAYMBhAGFAYYBhwGIAYkBiAGKAYkBiwGMAYYBjQGOAY8BkAGRAZIBkwGNAZQBlQGWAZcBlwGWAZgBmQGaAZsBfgF9AZwBhAGdAYkBiQGeAYcBngGfAaABoAGfAZABkAGhAZEBogGjAaEBoQGOAY0BlwGYAaIBpAGlAaYBpQGnAaYBqAGnAaUBqQGkAaoBqwGnAawBnAGtAX4BrgGvAbABsQGvAbIBrwGuAbIBrgGZAbIBswGaAZkBogGhAbIBsgGhAbEBsQGfAZ4BqwGdAaQBnQGEAaQBhAG0AbUBtQG0AbYBrAGeAasBrQGcAaoB/QC3AbgBuAH6AP0AuQG6ARMBuwFsAbwBCAF5AQ0BEgG5ARMBDQF5AUwBvQG+Ab8BCwEEAQYBvAHAAb8BdgF3AQgB9AAHAcEBBwHCAcEBwwHEAcUBxgHHATgBxwE0ATgBEwHDAcUBxAHIAcUByQHKAcYBywHMAWwBbAFyAQgBzQHOAWwBdAF1AQgBTAELAQ0BNQE0ARIBNAFUARIBxAHPAdABvwHRAcYBxgHRAccB0QHSAccB0wHUAdEB0QHUAdUB1gHSAdcB2AHXAdIB1QHZAdgB1QHUAdoBxAHbAdkBwwHcAcQBuQHbAboB2wG5Ad0B3QG5Ad4BVQHfAVQBxwHgAeEB1gHiAdIB0gHiAccB4wHkAccB5AHlAccB5gHnAccB6AHpAccB6gHrAccB7AHHAesB7QHuAccBxwHuATQB7wHwATQB8QHyATQB8wFWATQB9AG/AfUBvwHAAfUB9gHAAfcBwAG8AfcBvwH0AfgB+AH0AfkB+gH7Ab0BvgG9AfsBvgH7AfwB/QH+AdEB0QH/AdMB/gEAAs8BzwEBAtABAAICAtAByAECAsUBAwJSAQoBBAIFAgYCBwIIAgkCCgILAgwCCgIMAggCCAIMAg0CDAIOAg0CDwIQAhECEgITAhQCBAIGAhECEQIGAg8CCwIVAgYCBgIVAg8CTQEWAk4BFgIXAk4BGAJqAWsBGAIZAhoCSwFKARsCSgEXAhsCGQIcAhoCHAIdAhoCHQIeAh8CGgIgAhgCIAJqARgCIQIiAiMCIQIkAiICJQIhAiYCJwIkAiECKAIpAioCKwIsAi0CLgIvAiwCLAIvAjACKAIqAjECMQIqAjICLgIzAi8CKgI0AjICNQI2AjcCNgI4AjcCOQI6AjsCUQFQATwCPAJQAT0CPQJPAT4CTwFSAT4COQI/AjoCPwI4AjoCNgIlAjgCJQImAjgCOAImAkACQQJCAkMCMAJEAiwCQwIkAkECJAInAkECQgI5Ai4CLgI5AjMCMwI5AjICAAL+AQICPwI5AkICOQJSAQICRQJGAkcCSALdAd4B3gFHAkgCSQJIAkoCSwJMAkoCGAFIAk0CSgJOAkkCTwJXAVACUQJVAVICVQFTAVICVwFTAlQCVwFPAlUCRgJFAk8CTwJFAlUCRQJHAlUCVQJHAlECUwJWAlACUAJWAk8CSwJWAUwCVwLxAVYB8QHuAVYBWAIiAVkC+gBaAjIBWgJYATIB+gASAloCWgIYAVkBWgJZAVgBIgEZAVkCWQIZARgB+gC4ARICEwISAgUCagENAgUCWwJoAWoBXAJFAF0CXQJFAF4CXgJFAF8CYAJFAGECYQJFAFwCbQBnAGICYgJnAGMCZAJlAmYCZQJnAmYCZgJnAmgCaQJqAmsCawJqAmACagJFAGACaAJnAmwCbAJnAm0CZwJuAm0CbwJdAHACbwJxAl0AcQJyAl0AXQByAnMCcgJ0AnMCdAJ1AnMCYwJ2AncCdwJ2AngCeAJ2AnUCagJ5AnoCeQJ7AnoCegJ7Am4CewJ8Am4CfAJtAm4CfQJwAn4CfgJwAl0AfwJfAoACgQJfAoICXwKDAoICggKDAoQChAKDAoUChQKDAoYCgwJvAIYChgJvAIcChwJvAIgCiAJvAIkCbwBtAIkCiQJtAIoCigJtAIsCiwJtAGICEgK4AZoBjAKNAo4CjgKPAowCYgFjAWABXAGQApECWwKMAmgBjwKSAowCjAKSAmgBkwKUAowCjAKUAo0ClQJvAWEBbQGVAm4BpQGWApcCmAJFAJkCmQJFAJoBmQKoAaUBmgGzAZkCmQKuAbABmgG4AZsBmwG4AZoCmwKcAp0CngKfAsYBoAKhAqICogKjAqACnQKkApsCpQKmAqcCpwKmAqgCqQKqAqsCqgKsAqsCrQKuAq8CrwKuAj4BygHJAbACnwKeArECsQKeArICoQKgArMCswKgArQCtQKbArYCmwKkArYCpwKoArcCqwI+AbgCtwKoArkCuQKoAqsCtgK6ArUCugK7ArUCuwK8ArQCtAK8ArMCvQK+Ar8CsgLAArECwQLKAbACWALCAiIBwgI+ASIB1wHYAcMCwwLEAtcB2AHZAdsBxQLDAsYCxQLEAsMCxwLIAskCxQLGAsoCxgJ7AMoC5gHLAucB6AHMAs0C5QHkAcwCxwLJAs4CzgLKAs8CygJ7AM8CzwJ7AOoB7QHrAeoBMgI5AhgBWgLQAiECOQICAhgBIQIoAloCEAJzAVoCAgL+ARgB/gHbARgBGAHbAd0B3QFIAhgB0QJWAVgC0AJaAnMBKAIxAloCWgIxAhgB0gLTAhgBEAJaAtQCVgHuAVgCWwJqARICagEFAhICEgIUAloCGAFNAlkCWQLVAlgC1QLRAlgC1gLXAtgC2QJzAXEB2QJxAdcCcAGTAtcCBADaAtsCRQDcAt0CBABZANoCRQCYAtwClgKlAd4C3gKlAdsCpQGqAdsC3QLfAkUA3wJYAEUAugLgArsC4QK+Ar0CBgDKAeECwQLhAsoBBgDiAk0ATQDiAlUAVQDjAggAPgHjArgC5AK3AuMCtwK5AuMCBgDhAuIC4gLhAuUCPgEIAOMC4wLgAuQCwgLuAXsAewCaAMIC7gHCAlgC7QHqAXsA1wLmAtgCwwLbAecCwwLYAdsBwwLmAsYCewDuAe0B6ALpAuoCtwHrApUBlQHrApYBlAH9AJMB/QD8AJIBkgH8AJABiAH8AIoB/AD+AIoBjAH+AIYBgwH+AIEBgAHzAH8B8wDyAOwC7ALyAMIBAQAaAAMABQAEANsC7QK/AcYBBwFeAcIB7gK7AQUA7wIHAO0CygHvAu0CwgFeAe4CnAHCAe4CvAG/AbsBuwHuAmwB7gJeAWwBxgHKAe0CBQC/AQcAvwHtAgcAvwEFALsB7gKqAZwBhQCEAPAC8QLyAvAC8QLwAvMC9AKUAPAC2wKqAQUABQCqAe4CxgDHANwA9QKfAPYC9wLgAN4A4QD4AuIA+AKdAOIAmwD5AuQA4wD6AuQA+gKbAOQA+wKbAJoAmgDmAPsC5gDlAPsCsAClAPwC/QL8Av4C/wIAAwEDAQMAA6UAAAP8AqUAjQD8Av0CsgCwALUAAgO1ALkAtQADA4UAsAD8ArUA/AKNALUAtQCNAJAAkACNAI8ABAMFAwYD6gAHA+sA7QDsAAgDCAPsAAkDCgMLA+8ACwPwAO8AxgDxANsA8QAMA9sADAMNA9kA/gL8AgcDDgP9Ag8DDwP9Av4C6ADnAA8DBQMEAw4DEAMRAxIDAAP/AgsDCwMKAxMDCAMJAxQDFAMJAxUDegKMAlsCEgKaAVsCWwKaAXoCFQILAk0BcwEQAk0BcwF7AXgBcwFNAXsBBwIWA00BCwIKAk0BJgIXAwgB9wG8ARgDGQMaA7wBGwMcA7wBGwO8AR0DHQO8AR4DvAHZAh4DzAHQAtkCzAHLAdACzQEhAs4BIQLQAs4BHwPXAiADcwHZAtACGgMZAyEDIgMaAyMDJAMjAxkD1wLWAiADIgMjAyUDJQMjAyYDJwMoAykD2QLXAh8DKgMrA9kC9QEsAy0DLgPWAi8D9QEtA/QBLgMvA+YC5wLbAf4B5wL+AfwB+QEwA/sB5gLDAjEDwwLnAjED+QEyAzADOAEzA6ICogIzA6MCOgFJAaMCSAFGAZwCnAJGAZ0CRAGmAkUBpgKlAkUBrgKtAj0BrAKqAj0BPQE+ATQDBgAHAO8CBgDvAsoBkwKMAnoCNQPGAn8AxgLXAn8A1wJlAH8A1wKTAmUAkwJ6AmUAegKaAUUANgM3A3UAEQM2A3UAOAOOAMICwgKOAI0AmgCYADkD5gCaAHwAmgB7AHwAYQB7AMYCdgBhAMYCNQNjAMYCYwB2AMYCxgLmAtcCwgKaADgDdQAIABEDCACNABEDCAA+AY0AjQA+AcICMQAAAAsACwAAAAgAOgMMAAsADAA6AzUAOgM7AzUAOwM6AxIAFAASADwDPAMSADoDPQMUADwDPgM/AzwDPwM9AzwDPwM+A0ADPgNBA0ADNwA2AEEDNgBAA0EDOQA3ADoAOgBCAzsAQwM7AEIDQgNEA0MDRAM8AEMDRABBAD0ARAA9AEMARQMpAEMARQApAEUDPQBwAEUAPANzAG4AcwA8A3IARQNDAEUARQBDAD0APQA8AHAAPABEA3AARANCA3AAcABCA24AQgM6AG4ANwBBA24AbgBBAzwDQQM+AzwDPAM6A3IAcgA6A2kAOgMLAGkAbgA6ADcA6QB1ADcD6QDdAHUAXADdAHwA3QDfAHwA3wDmAHwAXAB8AFoARgNHA3kCagJIA3kCSQNKA0sDeQJMA00DTANJA00DfAJLA20CSgNOA08DTgNQA1EDUANSA1MDUwNUA1UDVgNsAlcDbAJYA1kDWANaA1kDWQNaA2YCWgNTA2YCUwNVA1sDXANdA14DXQNpAl4DXwNgA2EDYgNhA2MDYQNgA2QDagJpAkgDRgNiA0cDYgNjA0cDZQN+AmYDZwNoA2kDVQNUA2oDagNSA1ADVQNqA2UCagNmA2UCawNsA2oDagNtA2YDZwNlA20DbQNlA2YDXANeA24DXwJvA3ADcANxA3IDYANfA3MDXwN0A3MDXgJ1A3YDdQNwA3YDXANuA2ECXAJ3A3gDdwNeAngDXwJ5A14CXgJ5A3oDeQNwA3oDaQNoA3sDfgJlA3wDfQN+A38DgAOBA4IDgwOEA4UDhgOHA2IChANwA4gDaQN7A4kDewOKA4kDiQOKA4sDigN9AosDjAONA44DjQOPA44DgAOQA5EDkAOSA5EDkQOSA5MDkwOSA2MClAOVA5YDlQOXA5YDlgOXA5gDmQOaA5gDiQKbA5wDmwOHApwDhwKdA54DnQOfA54DoAOhA4UChQKhA6IDoQOjA6IDogOjA6QDowOlA6QDpAOlA4ECpQOmA4ECpgNyA4ECgQJyA3EDogOEAoUCpwOHAp4DmgNiApgDfQNxAn4DcQJvAn4DfAOoA34CqAN9An4ClAOGA2MCYwKGA2IChwKpA4YCqQOqA4YCqgOfA4YChgKfA4UChAKrA4ICgQJvA18CbgJnAmUAbgJlAHoCagJ6AkUAcABvAIMCbwBuAG0AZgBoAKwDaABxAKwDCABdAK0DcQAIAK0DfgJdAK4DZQBlAmEAYQBlAmIAXgBbAH4CfgJbAGAAXwCvA7ADrwN+ArADZQBnAmUCZwB2AmMCdQJ2AnMCfgKvA2YDZwCxA3YCdgKyA60DrwNfAGYDcACDAl8CXwJFAHAA2gCjALMDxgDaALQD2gCzA7QDtQO/ALYDvwC+ALYDtwO4A7kDwgDBALoDuwPMALwDzADLALwDxgC0A8QAtAO9A8QA8ALyAr4DpgCoAL8DwAOqAMEDwgOsAMMDrACuAMMDxAOvAMUDrwCxAMUDtwDGA7gAvQC8AMcDxwO8AMgDyQPwAr4DcAOEA8oDygOEA8sDhAODA8sDzAPLA6ADgwPNA8sDzQOgA8sDoAOFAswDhQLOA8wDzAPOA88DzwPOA9AD0APRA88D0QPSA88DzwPSA9MD0gOJAtMDiQLUA9MDmQPVA9YD1AOaA9MDmgOZA9MD0wOZA9YD1wOSA4ED1QPYA9YD1gPYA9kD2APXA9kD2QPXA4EDkgOCA4EDgAPaA4ED2gN9A4EDgQN9A9sD2wN9A38DfgPcA38DfwPcA90D3AOMA90DjAN9At0DfQLeA90D3QPeA98D3gPgA98D4APhA98D4gPjA2ADYQLjA+ID5APjA2EC5QPmA+QD5APmA+MD5wPmA+UDXgLoA+kD5wPpA+YDygPpA3ADcAPpA+gDZANgA+MD4wPqA2QDZAPqA+sD7APtA+oD7QN5AuoD6gN5AusD7QPsA0kDSQPsA0oDSgPsA04D7gNOA+wD7APvA+4D7gPvA2oD8ANrA+EDawPfA+EDbANrA2cD7wNrA2oD",count:1071},{rgb:[1,1,1],positions:"I/8UAkj/Gf+OAkj/T/8lAkj/jP4kAkr/vv5wA0j/rf7hAQYAi/85AgEA9v7DAgcA7/6LAwYA1v4cAwYA4P6MAwQAI/8TAkn/oP7LAQYA7P5IA4X/z/5xA0n/y/6NA1n/Z/87Alz/K/+LAnL/6P6OA7z/bf6cAUj/bf6bAUn/T/8jAkn/p/7LAUr/bf6aAUn/p/7LAUr/p/7MAUn/p/7MAUn/z/7nAUr/z/7nAUr/z/7nAUn/z/7nAUn/zv7oAUj/zv7oAUj/I/8TAkn/I/8UAkj/T/8lAkj/UP8+Akj/M/9lAkj/G/+PAkn/G/+PAkn/Gf+OAkj/8/7jAkn/zv5xA0j/M/9lAkj/8/7jAkn/3v6NA4L/6f6NA7z/6P6OA7z/3f6OA4L/5v6OA67/5v6OA67/3f6OA4L/3v6NA4L/wf0+AEj/rf1GAEn/f/1yAEj/f/1yAEj/N/2QAEn/O/2kAEn/4P26AEn/5P3KAEj/9v3xAEn/9/3yAEn/9/3yAEn/5v3JAEr/9/3yAEr/9v3xAEn/5P3KAEj/4P3jAEz/3/26AEj/4P26AEn/zf19AEj/5v3JAEr/5f2/AAAAx/1OAEr/x/1OAEr/hv0/AAQAIv14APH/Iv17AMD/Iv17AMD/Jf2dAFf/JP2DAAUAI/2OAFv/tf0gAMP/w/0mAAYAtP0cAAYA3/26AEj/zf19AEj/0P1/AAYA9/3yAEr/Kv8MAuoBr/7MARoCjwACAv4BqP2eAfgBof0EARECsv0AAucBXP3vALgBBP1jAbwBDPwuAZgByf3c/wcANP6s/gwAkP1BAAwA3f28/1cCiP1sAC8BjP64/nQCfPytAOUA7/x5AAMAR/3SAGsB5/z/AH8BCQD2AVgClgFd/g0Asf87/nQCLv/D/QsAbQHa/nQCUgJRAC4AVAEtAXMCgAHkAQgA7P6oBAMA7P4OBAgA5/43BLT/6v7NBAf/3/7BBKUAq/5+AxP/n/0dAXf+R/v+ANsAUf3ABEYCQPuGBLsBZvrDBMP/SvzIBMT9AvxWAUz+Kf5SAQcADf4eAQ3/Z/vrAFb/+fyqAB//XvyQAH4AJPygAHH/QvyPAOL/6P19AtIB3/07A84BzP8bAmkBXf62ApIBbv9eAiAA9/4+AwkArP7UAlABDQC4AWwDLgDGAT8DyP/AAVIDAgC6/1MEngBuAEUEvv8eAFcEqv8d/y8EP//a/0EE3QB5/zUETv8lAFIE+f/mADQEDf/rAO0DvP5aAO4Drf4AAO0Dsf7J/+0Dyv53/+0D6QB1/xsEPQGL/+0D6P5B/+0DDv8T/+0DVv/b/u0Dsv+3/u0D9v+t/u0DNQCx/u0DnADT/u0D7QAO/+0DUgEfAO0DPgFxAO0DUQHd/+0DEwHGAO0DyAASAe0DgAA4Ae0DPABOAe0DCgBTAe0DpP9GAe0DZP8sAe0D",indices:"AAABAAIAAwAEAAAABQAGAAcABwAIAAkACQAIAAoABgAFAAsACwAFAAwADQAOAA8ACAAHAA0AEAARAAcAEQANAAcAEgAPAAoAEwAUAAMACwAVAAYABgAQAAcAFQAQAAYADAAUABYAFAAXABYAGAAXABkAFwAUABkAFAATABoAGgATAAMADAAWABsAHAAYAB0AGAAZAB0AHgAaAB8AGgADACAAAwAAACAAHwAAAB4AHQAAABwAGwAAAAwADAAAAAsAIQAiABUAFQAiACMAJAAQAAIAEAAVAAIAEAAkACUAEQAQACYAEAAlACYAJwAlACgAEQAmACkAJwAoACkADQARACkADQApAA4ADgApACoAJAACACsAAgABACsAKgAsAAQABAApAAAAKQAoAAAADwAOAAQABAAOACoADQAPAC0ALgANAC0ACgAIABIALwAIAC4ALgAIAA0AMAASADEAMgAvAC4ADwASADAAMwAyADQAMgAuADQANAAPADMACQAFAAcANQA2ADcAOAA5ADoAOwA8AD0APQA+ADsAOwA/AEAAPwBBAEAAQgBDAEQARQA8AEYARQBGAEcAOwBIAEkANQBHAEoARwA7AEoAOwBJAEsASwBJADUATABNAE4ATwBNAFAATQBRAFAAUABSAE8AUgBMAE4ANQBMADYATAA1AFMAUwA1AFQATABTAFUAVQBTAFQANwA6AFYAOgBEAFYAVgBEAEMAVgBXADcAVwA1ADcAQgBBAD8AUQBMAEkASQBMAFgATABUAFgAVABMAFUAUAA5AFIAOgA5AFAAUgA5ADgATABSADgATQBMAFEATAA3ADYAWQBJAEgAVAA1AFgASQBYADUAWgBbAFwAXQBbAFoAXQBeAFsAWgBfAF0AYABdAGEAXgBdAGAAXQBfAGEAYQBfAGIAYwBkAGUAZgBeAGAAZwBkAGAAYABkAGYAZABoAGYAaQBqAGUAZQBkAGcAawBgAGEAbABlAGsAawBlAGcAZwBgAGsAXABbAG0AbgBvAHAAbgBxAG8AcgBxAG4AcgBzAHEAXABzAHIAXABtAHMAcABvAGgAZABwAGgAXAByAHQAdQB2AHcAdQB4AHkAdwAEAHoAdwAPAAQAdgAKAHcACgAPAHcAegAEAAMAdQB3AHgAdwB6AHgAAwAUAHsAfABiAH0AfAB9AH4AfwB8AH4AgACBAH8AeAB7AIAAewCBAIAAAwB7AHoAewB4AHoAfQB5AHgAfwB+AHgAeAB+AH0AeACAAH8AFAAMAIIAgwAUAIIASQCDAIIAewCDAEQARACDAEIAQgCDAFkAYgBsAGEAawBhAGwAFACDAHsAbABiAGkAhAB8AH8AhAB/AIEAhACBAHsASQBZAIMAOgBQAIUAaQBiAIYAYgB8AIYAhACHAHwAhwCEAHsAhQB7ADoAOgB7AEQAhQCHAHsAbABpAGUAUABqAIUAhQBqAIcAiAB8AIcAhgBqAGkAUQBqAFAAhwBqAIgAiABqAHwAagCGAHwAXwB9AGIAiQCKAH0AdgB1AHkAdACLAFwAXwBaAIkAjAB5AIoAeQB9AIoAdACNAIsAjQCOAI8AjgB2AI8AdgB5AI8AjwB5AIwAfQBfAIkAiQBaAIwAjACNAI8AiQCMAIoAjABaAI0AjQBaAIsAiwBaAFwASQBlAFEAZQBqAFEASQCCAAwASQBjAGUADACNAEkACQCNAAUABQCNAAwACgCOAAkAjgCNAAkACgB2AI4AcABkAHQAcAB0AHIAdABkAI0AZABjAI0AjQBjAEkAcAByAG4AkACRAJIAkwCUAJUAlgCVAJcAmACTAJYAkwCVAJYAlwCVAJkAlQCaAJkAmgCVAJQAlACTAJgAmQCbAJwAnACdAJkAnQCeAJkAngCfAJkAmACgAKEAmQCfAKIAmQCiAJcAogCjAJcAlwCjAJYAlgCjAKQApAClAJYApQCmAJYAlgCmAKcApwCoAJYAlgCoAJgAmACoAKkAmACpAKAAqQChAKAAmACqAKsAoQCsAJgAmACsAKoAmACrAJQAqwCtAJQArQCuAJQArgCvAJQAlACvAJoArwCwAJoAsACxAJoAsQCyAJoAmQCaALMAmgCyALMAmQCzAJsA",count:265}],link5:[{rgb:[.039,.051,.055],positions:"cwGlA5j+SAG2A0D+SAHJAwD+MgHCA9f9OQG+Ayz9QgHHA9T9KgG6A1P9zQFtA1b/6gEvAw4AxQFdA3D/3AEaAz4A0gEIA3cAsQHkAu8AeQHOAioBfwHNAj8BXgHBAmQB6wClArwB3wCjArIBvwCfAtABMgCSAuYBMQCTAvUB4v+SAvcB4v+RAugBn/+UAt8BRP+eAtMBwv69AmABC/+nArYBpf7AAmgBg/7LAj4BUP7kAvEAOf70Ar4AH/4QA2cAF/5DA8b/Rf5mA1b/xf7IA479yf6/A/H9sv7HAxb+of6nA4T+1v7AA3390v4KA1X5yf69Azr9kgDmAxv7kwDpAxv7hQCsA+T5jADAAyv6TgCjA+74YACMA0P5f/+pA9P5yP/JAxL60//GAyb6SQHJBOL/LwHKBA8AQwHQBCAAmABLBGD9zf9mBEn9zv9ZBFr9i/6nA5j+Tv59AyD/Ov5uA03/Y/6LA/P+Tv59AyD/Ov5uA03/yf69Azr9Y/6LA/P+f/6aA7/+i/6nA5j+yP4xAxP60/73AuH40P4HAzz5yf4YA3z50P4LA1T54/7oAnH48f7jAlT46f7jAnf40f4QA9744/7oAnH48f7jAlT4Ff/aAh74Hv/TAh/4NgFIA5T6KgHzAtX4QgHHA9T9nv+VAu0Bnv+VAu0B2AEFA5AA6wClArwBvwCfAtAB2AAeBCb81gAdBBb8rQApBBH81gAZBBb81gAcBBb87AASBA/81gAcBBb81gAdBBb87gBuBOv91AD+A2b71gAQBM/7wwAbBOT7wwAZBNr7wwAWBNv7qgD+Axv71QD7A2b7JQEYBAb9JQEYBAf9cf/VA1P6lf/XA0P6av/DA/75lf/XA0P6uP/aAzT6vf/VAxf6uP/cAz36yf/hA0r6uP/eA0f6sf/dA0r6cf/eA4P6Yf/pA8j6r//wA7H6uP/xA7D6uP/sA5b6sf/dA0r6q//dA0z6q//fA1v6q//iA2r6sf/jA2z6uP/lA276uP/oA4H6qv/sA5/6nf/rA6j6ov/tA6z6p//uA7H6uP/yA7n6yf/3A8f6uP/0A8L6lf/vA8P6cf/nA7L6cf/pA7v6cf/qA8T6gP/pA7L6j//rA7H6gP/nA6X6cf/iA5j6cf/gA476o//oA476t//oA4H6lP/gA3P6j//nA5z6gP/jA5D6cf/YA2X6cf/XA1z6cf/uA9r6cf/wA+P6cf/8Ayj7cf/2AwT7hv/9Ax/7hv/6Awz7m///AxX7lf/1A+L6cf/yA/D6cf/0A/r6lf8EBDv7cf8ABDz7cf8CBEj7cf8GBGP7Xv8VBMT7cf/+AzL7h/8LBGv7jf8MBGv7jf8JBFv7uP8JBDr7ef8DBEf7gP8EBEf7gP8KBGv7gP8HBFn7jf8GBEr7lf8HBEr7nP8IBEr7nP8LBFv7qf8MBFj7qf8JBEX7nP8OBGv7o/8PBGv7qf8QBGr7cf/tA9H6lf/xA9D6uP/2A8/6uP/4A9j6uP/6A+H6lf/3A+/6uP/8A+/6uP/9A/b6uP//A/76sf8CBBX7sf8DBBr7uP8GBCr7sf8BBA/7nv/9Awf7ov/8A//6jP/5AwD7ov8DBCv7nv8BBCP7jP8ABCv7uP8IBDL7cf8YBMb7cf8WBL37sf8KBEX7uP8LBEX7uP8QBGH7uP8VBHz7lf8QBH37cf8LBH77lf8YBK37uP8bBJ77yf8jBMP7uP8cBKj7uP8eBLH7sf8dBLT7cf8hBPj7cf8fBO37cf8sBDv8W/9BBMD8nP81BEv8h/8yBEz8h/81BFv8cf8vBEz8cf81BGv8cf8uBET8cf8pBCX8cf8nBBz8q/8gBMX7q/8iBNT7sf8kBNb7q/8dBLb7uP8oBOv7uP8sBAD8uP8lBNj7p/8uBBv8ov8tBBf8qv8rBAn8nf8rBBL8r/8vBBv8uP8wBBv8uP8yBCT8uP80BCz8uP8/BHH8uP8+BGj8uP85BEn8o/87BGn8o/84BFn8jv84BGn8lf9IBLz8cf9ABK78cf8/BKT8cf89BJv8uP9CBH38uP9BBHn8lf8/BIz8lf88BHr8cf84BHv8cf82BHP8cf8qBC78lf8vBC38lf8xBDr8uP82BDr8uP83BEL8cf8iBAL8gP8nBA/8gP8pBBz8j/8rBBv8sf9EBJL8q/9EBJX8q/9HBKT8q/9JBLP8sf9KBLX8uP9FBJD8uP9MBLf8yf9mBD/9uP9DBIb8o/8oBPn7t/8oBOv7lf8hBN37j/8nBAb8gP8jBPr7cf8ZBM/7uP9NBMD8uP9NBMD8uP9PBMr8cf9RBAv9cf9OBPv8cf9LBOz8cv9KBOP8dP9JBN38e/9IBNP8fv9IBNL8d/9JBNj8eP9IBNb8g/9JBM/8hP9JBM/8iv9KBM78kf9LBM/8lP9LBND8mf9MBNL8m/9NBNP8n/9OBNf8oP9OBNn8of9PBNr8rP9PBNP8iP9bBDP9kP9cBDP9kP9ZBCT9cf9XBCz9cf9SBBL9ef9TBBL9gP9aBDP9gP9XBCP9gP9UBBL9kP9XBBT9uP9PBMv8uP9RBNb8uP9TBOD8rv9SBOX8pP9SBOr8pP9TBPH8pP9UBPf8rv9WBPf8uP9XBPf8lf9VBAr9nv9YBBT9uP9aBAn9nv9eBDP9q/9gBDL9nv9bBCP9uP9hBDL9uP9YBAD9uP9jBDv9uP9kBET9lf9gBEX9wv9pBFf9w/9pBFj9cf9bBEb9cf9XBCz9Vv9sBLL9eP++A935cf+8A9f5Vv9SBAf9Uv9rBJD9Tv9zBLv9Pf+DBBH+Mv+KBDz+Mv+DBHf+vf7QBCAA2v60BHj/t/7JBOL/zf9kBD/9y//dAzX6ZP9cBLr9Df9/Awr5hf+lAzz5d/99A3T4Vv/+Axv7Cv82BPj83f7BAxb72/4YBAb9TP5tBOb/Cf4KBB0ACf4KBB4AE/9tBN/9Uf9UBAf9Uv9cBDf9yf65BGD/1f6zBDX/qv5kBI/+tf7IBOL/v/6+BIv/1v45BMv9Cf4IBB0AI/75A74AEv7+A4AARP7tAwoBRP7tAwoBXf7qAzUBnP7gA4EBwP7dA6IBwP7dA6IBEv/YA9kBP//VA+4BUv/UA/YBP//VA+4Bnf/TAwsCAADRAxUCMf9HA1/4WP8/AzH4Ff/aAh74gv/SAtH3Mf9HA1/4Df9UA6z44P6YAy/63f7AAxb72v4WBAf92v4eBDr92v4eBDr92P4mBG392P4mBG392P4nBG39iP4vBJX+cP4pBMb+RP4jBCL/Cf4JBB0AE/4UBLb/Cf4IBB0A2//qBHYBnv63BGUACf4KBB4Abf+7A8/5Wv/9Axv7Wf/9Axv7Vv9SBAf9Vf9TBAf9Vf9TBAf9Wv/9Axv77gDJA2b6tACZAwv54QD/AhL4JQEhBDr97QEUBLb/iQGcBLj/9wELBB0AYAGxBLv/MgDRAxICwQDVA+4BlgDYAwAC7gDXA9kB7gDXA9kBQAHdA6IBcQHiA3QBQAHdA6IBvAHtAwoBowHpAzQB7gH+A4AA0QHyA94A0QHyA94A9QECBE8A9QECBE8A9wEIBB0AIAGYAy/6IwHBAxb7IwHAAxb7GwGEA7n5MQH9AtL49wEIBB0AcAEuBIL+vAEjBCL/NAExBNL9KAEnBG39JgEWBAf9JQEhBDr9kwDpAxv7pgD9Axv7pwD9Axv7qgBSBAf9pgD9Axv7cAFnBBIB9wEKBB4ArgBrBI/9rABbBDf9qgBSBAf9lf9PBOX8lP9PBOP8gP9NBOv8k/9OBOP8kv9OBOH8kf9OBOH8j/9NBOD8jv9NBOD8gf9NBOf8i/9NBOD8iP9MBOD8h/9MBOD8hf9MBOH8hP9MBOL8g/9MBOP8gv9MBOT8gf9MBOb8gP9OBPL8lv9RBPH8gP9NBOv8lv9QBOv8lf9PBOf8gP9QBPj8i/9RBPj8lv9SBPj8kf9CBKD8hf9BBKX8kf9EBKn8nf9GBK78nf9FBKT8nf9DBJv8kf8bBMH7hf8aBMb7kf8dBMr7nf8fBM/7nf8eBMX7nf8cBLz7kf/bA1f6hf/aA1z6kf/cA2D6nf/fA2X6nf/dA1v6nf/bA1L61QD7A2b71AD7A2b71AD+A2b71AD7A2b7wwAWBNr7wwAWBNv7wwAWBNr7wwAZBNr71gANBND71gAQBM/71gANBND71gAZBBb8IwHaBHsA9gDhBL4AQwHQBCAAIwHaBHsAtv7IBOL/tf7IBOL/t/7JBOL/tv7IBOL/CwGnBOH+DAGnBOD+7ACZBI7+KQGzBDT/EQGrBCj/QAG+BIr/KgGzBDT/KQGzBDT/wQCCBBH+7ACZBI7+rQBcBDf9rABbBDf9rwBrBI/9rAB0BA7+sgBzBLv9uAB7BOb9rABbBDf9rgBrBI/9swBzBLv9rgBcBDf9uAB7BOb9QAG+BIr/SQHJBOL/KgGzBDT/DAGnBOD+rgBcBDf9rQBcBDf9rwBrBI/9sgBzBLv9swBzBLv9CwGnBOH+rgBUBAf9rQBUBAf9qwBTBAf9qwBTBAf9rQBTBAf9rQBUBAf9rQBUBAf9Pf+DBBH+Rv97BOb9tv7IBOL/1v6zBDb/9P6nBOL+1f6zBDX/Tf9zBLv9Uf9rBI/9U/9cBDf9U/9cBDf9Uv9cBDf9E/+ZBI/+SP97BOf9VP9bBDf9Uf9rBI/9Uv9rBJD9Tv9zBLv9Tf9zBLv9Rv97BOb9VP9bBDf9SP97BOf9Mv+KBDz+E/+ZBI/+v/6+BIv/yv65BGD/1/6zBDb/yv65BGD/yf65BGD/1v6zBDb/1/6zBDb/9P6nBOL+Vf9TBAf9Vf9TBAf9VP9TBAf9VP9TBAf9U/9UBAf9U/9UBAf9U/9UBAf9Uv9UBAf9Uv9cBDf9qQD+Axv7rQBTBAf9rQBUBAf9pwD9Axv7pgD9Axv7qwBTBAf9qwBTBAf9rgBUBAf9qQD+Axv7qQD+Axv7qAD+Axv7pwD9Axv7qwBTBAf9VP9TBAf9Wf/9Axv7Wf/9Axv7WP/+Axv7Uf9UBAf9V//+Axv7Uv9UBAf9VP9TBAf9Wf/9Axv7Uv9UBAf9U/9UBAf9V//+Axv7pgDiA376mgDEA+P5pgDiA376qQD+Axv7qgD+Axv7qAD+Axv7qQD+Axv7qAD+Axv7qf+QAyv5Wv/iA376Vv/+Axv7V//+Axv7V//+Axv7WP/+Axv7Wv/iA3762/4YBAf9sf4zBDX+zP4xBNL9RP4jBCL/sf4zBDX+2P4nBG392/4YBAf92v4WBAf93f7AAxb72v4WBAf93f7BAxb72/4YBAb9Cf4JBB0A5P6DA7n5XADOAsL34P6YAy/6AADRAxUCP//VA+4BEv/YA9kBwP7eA6IBXf7qAzUBwP7eA6IBGwGEA7n5CAFlAwj5IAGYAy/6IwHBAxb79wEIBB4A9wEIBB0A9wEIBB4A9wEJBB4AwQDVA+4BMgDRAxIC9wEJBB4A9wEKBB4AJQEYBAb9JQEYBAf9IwHAAxb79wEKBB0A9wEKBB0A9wELBB0A4AEaBIT/vAEjBCL/KAEnBG39JgEWBAf94AEaBIT/Xv9rBK39vv9oBF/9vP9pBF39vP9pBF39vf9pBF79Xv9rBK39vf9pBF79x/9oBFf9vv9oBF/9wv9pBFf9zf9lBD/9yv9nBEf9zf9lBD/9y/9lBD/9y/9lBD/9yv9mBD/9yv9nBEf9yv9mBD/9zf/cAzX6y/8hBLf7y/8hBLf7zf/cAzX6yf9mBD/9vf/VAxb6vf/VAxf6eP++A9z5eP++A935eP++A9z5fv/KAuL30P4LA1T5EAHgAmb4nQDLAu73iP/eBMQArgBsBAj+hP9BBKX8hP9CBKX8kf9EBKn8hf9BBKX8hP9BBKX8kf9EBKn8kf9CBKD8hP9BBKX8kf9CBKD8kf9OBOH8kv9OBOH8k/9OBOP8lf9PBOX8lf9PBOf8lf9QBOf8lv9QBOv8hP9MBOH8hP9MBOL8g/9MBOP8hf9MBOH8hP9MBOL8g/9MBOP8gv9MBOT8gf9NBOb8gf9MBOb8gf9NBOf8iP9MBOD8hv9MBOD8h/9MBOD8gP9QBPj8gP9OBPL8gP9NBOv8kf/cA2D6hf/aA1z6hP/aA1z6nf/dA1v6nf/cA1L6nf/bA1L6kf/bA1f6hP8bBMb7kf8dBMr7hP8aBMb7hf8aBMb7hP8aBMb7kf8dBMr7kf8dBMr7nf8gBM/7nf8fBM/7nf8eBMX7kf8bBMH7kf8bBMH7t//oA4H6o//oA476uP/oA4H6lP/gA3P6lP/gA3P6cf/ZA2X6cf/YA2X6cf/XA1z6cf/VA1P6uP/aAzT6lf/XA0P6uP/zA7n6uP/yA7n6uP/xA7D6uP/0A8L6sf/jA2z6q//iA2r6sf/kA2z6uP/lA276p//uA7H6p//vA7H6r//wA7H6ov/tA6z6qv/sA5/6ov/tA6z6nf/rA6j6lf/yA9D6lf/xA9D6cf/tA9H6uP/2A8/6nv8BBCP7sf8DBBr7nv8CBCP7jP8ABCv7sf8CBBX7sf8BBA/7sf8DBBr7qf8QBGv7qv8QBGv7qv8MBFj7qf8MBFj7qf8QBGv7qf8QBGr7qf8QBGv7qf8MBFj7qv8JBEX7qf8JBEX7sf8KBEX7o/8PBGv7o/8PBGv7jf8GBEr7jf8GBEv7lf8HBEr7cf8LBH77cf8CBEj7cf8GBGP7jf8JBFv7o/8oBPn7j/8nBAb8j/8nBAf8t/8oBOv7o/8oBPn7uP8oBOv7gP8jBPr7cf8hBPj7cf8iBAL8cf8jBAL8gP8nBA/8q/8dBLb7sf8dBLT7sf8eBLT7uP8eBLH7uP8zBCz8uP80BCz8lf8vBC38uP80BCz8uP8zBCz8lf8vBC38uP8yBCT8uP8wBBv8uP8yBCP8uP8yBCT8uP80BCz8sf8kBNb7uP8lBNn7uP8lBNj7uP8oBOv7qv8sBAn8nf8rBBL8qv8rBAn8uP8sBAD8o/84BFn8uP85BEn8o/85BFn8jf84BGn8jf84BGn8jv84BGn8o/87BGn8o/87BGn8uP8+BGn8uP8+BGj8uP9ABHH8uP8/BHH8uP8+BGn8uP8/BHH8uP9BBHn8l/9YBBT9l/9YBBT9nv9ZBBT9nv9YBBT9nv9bBCP9cf9BBK78cf9ABK78lf9IBLz8sf9KBLX8q/9JBLP8sf9LBLX8uP9MBLf8cf8/BKT8q/9EBJX8sf9EBJL8uP9FBJD8uP9XBPf8uP9ZBAD9uP9YBAD9uP9aBAn9iv9KBM78hP9JBM/8hf9JBM/8g/9JBM/8g/9JBND8fv9JBNL8fv9IBNL8fv9JBNL8e/9IBNP8eP9JBNb8e/9IBNP8eP9JBNf8g/9JBND8hP9JBM/8e/9IBNP8eP9JBNb8eP9JBNf8d/9JBNj8e/9IBNP8eP9IBNb8d/9JBNj8rv9WBPf8pP9UBPf8pP9UBPj8oP9OBNn8nv9OBNf8n/9OBNf8m/9NBNP8n/9OBNf8oP9OBNn8pP9TBPH8",indices:"AAABAAIAAQADAAIABAAFAAYABQADAAYABwAIAAkACQAIAAoACwAMAA0ADAAOAA0ADgAPAA0ADwAQAA0ADQAQABEAEQASABMAFAAVABMAFgATABUAFgAVABcAFwAYABkAGgAZABgAGgAbABkAGQAbABwAHAAdABkAHQAeABkAHgAfABkAIAAZAB8AIQAZACAAIgAjACQAJAAjACUAIgAmACMAJwAmACgAKQAqACsALAAtACsAKwAtAC4ALwAwADEAMgAzADQANQAqACkANgA3ADEAJQA4ACQAOQAhADoAOwAlADwAJQAhADwAIQAgAD0AJgAiAD4APwBAACUAQABBACUAKABCACcAQwBEAEUARABGAEUAJwBFAEYARwBIAEkASQBKAEsATABNAE4AJwBCAEUARQBKAEMAQwBKAEkABAAGAE8ABgBQAE8AAwBRAAIAAAAHAAEAAQAHAAkAGAAXAFIAFwAVAFMAVAAKAAgADAALAFQACwAKAFQAEwASABQAEQBVAFYAVwBYAFkAWgBbAFwAXABbAFcAVwBdAF4AWQBfAFcAYABhAFwAWABaAFkAWgBiAFkAWQBiAGMAWQBjAGAAYwBiAGQAZABiAGEAYwBhAGAAYABlAFkAZQBgAGYAZgBcAGcAZwBcAGgAYABcAGYAXABXAGgAaQBqAGsAbABtAG4AbQBvAG4AbgBvAHAAbwBxAHAAcABxAHIAcwBrAHQAdQB2AHcAeAB5AHAAeQB6AHAAcAB6AHsAewB8AHAAfAB9AHAAcAB9AH4AfwCAAIEAfwCBAHcAgQCCAHcAdwCCAHUAgwCEAHYAhABwAHYAdgBwAHcAcAB+AHcAgwCFAIQAhQCGAIQAhACGAHQAhwB0AIgAiAB0AIkAdACGAIkAigCLAIwAigCMAIcAjACNAIcAhwCNAHQAjQCOAHQAdACOAHMAjwCQAJEAkgCPAJMAjwCRAJMAkwCRAHMAkQCUAHMAcwCUAGsAlACVAGsAawCVAGkAlgB0AJcAdACYAJkAmACaAJkAmQCaAJsAmgCcAJsAnQCXAJ4AlwB0AJ4AngB0AJ8AdACZAJ8AoAChAKIAowCiAKQAogChAKQApAChAHQAoQClAHQAdAClAJgApgCnAKgAoACiAKkAogCqAKkAqQCqAKsArACmAK0ApgCoAK0ArQCoAKsAqACuAKsAqwCuAKkArgCvAKkAqQCvALAAsQCyALAAsgCzALAAsACzAKkAsQC0ALIAtAC1ALIAsgC1ALYAlgC3AHQAtwC4AHQAdAC4AIQAuAC5AIQAhAC5ALoAnQCeALsAngC8ALsAuwC8AL0AugC7AIQAuwC9AIQAvQC+AIQAhAC+AL8AwADBAMIAwwC/AMQAvwDFAMQAxADFAMYAwgDBAMcAwQDIAMcAxwDIAMkAwwDAAL8AwADCAL8AvwDCAIQAwgDKAIQAhADKAKkApADLAMwAswDNAKkAzQDOAKkAqQDOAIQAzgDPAIQAhADPANAApADMANAA0ADRAKQA0QDSAKQApADSAKMAzADTANAA0wDUANAA0ADUAIQA1ADVAIQA1ADWANUA1gDXANUA1wDYANUA2QDaAKQA2wCkANwA3QDeAN8A3gDgAN8A3wDgAOEA4QDgANwA4ADiANwA3ADiANsA4wDkAKQA5QDmAOcA1QDYAOUA5QDYAOgA6QDqANUA5QDnANUA5wDrANUA1QDrAOkA7ADqAO0A6gDuAO0A7QDuAO8A7ADwAOoA8ADxAOoA6gDxANUA8QDyANUA1QDyAPMA9ADVAPUA1QD2APUA9QD2APcA9gD4APcA9wD4APkA+gD7ANwA+wD8ANwA3AD8AP0A/gD/AAAB/wABAQABAAEBAf0AAQECAf0A/QACAdwAAgEDAdwA3AADAeEA4wCkAAQBpADbAAQBBAHbAAUB2wAGAQUBBQEGAfMABgEHAfMA8wAHAdUABwEIAdUA1QAIAfYA2QCkAAkBpADkAAkBCQHkAAoB5AALAQoBCgELAQwBDQEOAQ8BEAERAQ8BEQESAQ8BDwESAQ0BEQETARIBEwEUARIBEgEUARUBFQEUAf4AFAHVAP4A/gDVAP8A1QD0AP8AFgEXARgBGQEWARoBFgEYARoBGgEYAdoAGAEbAdoA2gAbAaQAGwHLAKQAEwEcARQBFAEdAR4BHwEgAdwAIAEhAdwAIQEiAdwA3AAiASMBJAElAdwAIwEmAdwAJgEnAdwA3AAnASQBJQEoAdwAKAEpAdwA3AApAfoAKQEqAfoA+gAqASsBKwEsAfoALAEtAfoA+gAtAR4BLQEuAR4BLgEvAR4BHgEvATABMAExATIBMwE0ATUBNgE3AdwA3AA3AR8BNwE4AR8BOQEzAToBMwE1AToBOgE1ATsBNQE8ATsBMAEyAR4BMgE9AR4BHgE9ARQBPQE+ARQBFAE+AT8BQAFBAUIBQwFEAUIBRAFFAUIBQgFFAUABOAE7AR8BOwE8AR8BHwE8AUYBPAFHAUYBRgFHAUgBSQFKAUsBSgFMAUsBSwFMAUcBRwFMAUgBTAEUAUgBSAEUAU0BTQEUAUUBFAE/AUUBRQE/AUABTAFOARQBTgFPARQBUAFRAU8BUQFSAU8BTwFSARQBUwFUAVUBVQFUAdwAUQFQAVUBVQFQAVMBbABuAGsAbgBWAWsAawBWAVcBVQFYAVkBWAFVAdwAWgFVAVkBWwFcAV0BXgFfAWABNgAxAGEBYQExAGIBWgFjATcAZAFlAWYBZwFkAWgBZAFpAWoBagFoAWQBawFsAW0BZwFuAW8BbwFuAXABcQFyAXMBdAF1AWsBawFxAXMBcwFuAXYBaAFuAWcBHwB3ASAAHgB4AR8AeAF5AR8AHgAdAHoBewEdAHwBfQF8ARwAHAB8AR0AHAAbAH0BfQEbAH4BGwAaAH8BfwEaAIABgAEaAIEBgQEaABgAggGDARgAUgCEARgAGACEAYIBFQCEAVMAhQGEARUAhgGHAYgBiAGHAYkBTQBMAIoBiwGKAUcARwCKAUgAiwFLAEoARQBCAIwBaQGMAUIAQgCNAWkBjgEoAI8BkAE+AJEBkgE+AJMBPgAiAJMBJAA4AJQBlAFBAJUBQQBAAJUBQAA/AJUBlQE7AJYBOwA8AJYBOQA6AJYBPQAgAJYBIACXAZgBmQGXASAAjQEoAI4BKACNAUIAmgGbAXgBdAFrAV4BnAGbAWsBVwGdAWsAngF0AJ8BawCfAXQAnQEvAGUBoAGkAKEBogGkAKMBdACjAaQApACgAdwAZgCkAWUApQGmAS0AaABXAKcBVwBfAKcBqAGpAaoBqwEyAKkBFQAUAIUBhQEUAKwBrQGuARIAEgCuARQArgGsARQAVgBVAK0BrQFVAK8BsAEQALEBEAAPALEBsgGzAQ8ADgCyAQ8AtAG1AQwADAC1AQ4ADgC1AbIBDABUALQBtgG3AVQAVAC4AbQBVAC5AbYBVAAIALoBugEIALsBvAG9AU8AvQG+AU8AvAFPAL8BvwFPAMABwQEIAAcAwgHDAQcABwAAAMIBAAACAMIBUQDEAQIABADFAQUAxQHEAQUAxgHHAQQABABPAMYBxgFPAL4ByAHJASsAyQHKASsAKwDKASwAywHMATUANQDMASoAqQHNAaoBzQHOAaoBzwHQATUA0AHRATUA0gHTAdQB0wHVAdQB1QHWAdQB1AHWAdcB2AHZAdoB2QHbAdoB2gHbAdwB1wHYAdQB2AHaAdQB3AHdAdoB3QHeAdoB2gHeAd8B3wHgAdoB4AHhAdoB2gHhAeIB4wHkAeUB5AHmAeUB5gHnAdQB1AHnAdIB4wHoAeQB6AHpAeQB5AHpAeoB6wHsAe0B7gHvAe0B7wHwAe0B7QHwAesB8QHyAfMB9AH1AfMB9QH2AfMB8wH2AfEB9wH4AfkB+gH7AfkB+wH8AfkB+QH8AfcB/QH+Af8BAAJmAGAAAQJhAGMAAgIDAgQCAQIFAgYCZABhAAECYQAHAgECYQBiAFwAXABiAFoAXQAIAl4ACQI0AAoCCgI0ADMACwKpATIAzQGpATQANAAMAs0BDAIKAs0BCgKaAc0BDQIOAl4BXgFrAZsBDwIQAl4BmgFeAZsBEQISAhMCFAIVAjMAMwAWAhcCGAIXAhICEgIRAhgCFAIzABcCGQIVAhoCFQIUAhoCGwIcAh0CHgIVAhkCzwE1AB8CIAIeAhkCIQIiAh0CHQIiAh8CHwI1ACACIAI1AB4CIwJfACQCIwIlAl8AJQIZAl8AXwAZAhMCqQEmAqsBJgInAqsBqQEXAiYCKAKpASkCKQKpAV8AKgIrAiMCKwIsAiMCLAItAi4CLgItAiUCGgIUAi8CXwATAikCFgIzACcCJAJfADACKwIqAjECMQIqAjAC0QHQATICMwIhAjQCNAIhAjUCHAIbAjYCcwE3AjgCdQF0ATkCcQFrAXUBOgI7AjwCcgE7AnMBPAJxAToCOwI3AnMBPQJuATgCOAJuAXMBPgI/Aj0CQAJBAj0CXQFcAUICQwJbAWMBWwFdAWMBYwFaAUMCRAJFAkYCRgJFAkcCRQJIAkcCRwJIAkkCWAFKAlkBRwJJAksCSwJJAlsBTAI3Ak0CXwF1AWABQgJfAV0BEAIPAnUBTgJfAU8CTwJfAVACTgJRAlICUgJRAlMCUQJUAlMCUwJUAlUCUAJfAVUCXwFCAlUCcAFuAT0CRAI/AkUCNwI7Ak0CWAFWAkoCRAJXAj8CVwJYAj8CWQJaAj8CQAJbAkECXAJdAl4CXgJdAm8BXwJgAmECYgJjAmQCYwLLAWUCMAJfAFkAYQJmAl8CWQBlAGcCZwJmAlkAaAJpAjQCaQJqAjQCNAJqAmsCbAJtAloCWgJuAm8CZwFwAnECcAJyAnECcwKiAXQCdAKiAZ4BdQJ2AncCdwJ2Am8CeAJ5AiwAeQItACwAeQKlAS0AZQCkAXoCegKkAaUBegJ7AnwCfQJ+AngCygF/AngCeQJ4AqUBeAIsAMoBgAJlAS8AgQJrAGUBawCdAWUBnwFrAIECggKDAoEChAKFAoEChgJkAWcBZQFkAYECZQEtAGYBhQKfAYECZQGAAi0AaAFqAYcCaAGHAm4BhwKQAW4BdgFuAZABiAJ2AYkCdgGIAnMBawGXAWwBlwFrAZgBawFzAZgBmAFzAZYBigJzAZUBlQFzAZQBlAFzAYsCiQJ2AYwCdgGQAYwClgEgAJgBkAGRAZMBiAKJAiQAIgAkAIwCjAIkAIkCJACUAYsCkAGNAo4CjwKQApECkAKNApECjQKSAmkBnAFsAZMClAJkAUUARQCMAZQCiwFKAGQBhwFmAYkBlQKJAWYBhwGKAWYBigGLAWYBiwFkAWYBZAGUApYCSgBFAGQBZAGWAmkBmwF5AXgBeQGbAZwBlwKaAYQBhAGaAZgCmAKaAZkCmQKaAZoCmgKaAX0BfQGaAZsCmwKaAXsBewGaAXgBnAJ9AX4BmAKCAYQBHwCcAXcBHwB5AZwBegF4AR4AkwJ3AZwBfwGZApwCvwGlAaQBnQKkAb0BpgGeAsABnQK9AZ8CpAFmAKACpgGlAZ4CpgGVAi0AngKlAb8BZgEtAJUCwAGeAr8BugGhAqICugG7AaMCogKkAroBtgHNAbcBtwHNAbQBzQGaAbQBtAGaAbUBtQGaAbIBsgGaAbMBswGaAbABrgGlApoBpQKwAZoBzQG6Ac4BlwKmApoBmgGmAq4BzQG2AboBugGnAqgCZgBnAKACqQKqAr0BqgKrAr0BqgLGAb4BqgHOAawCrQKoAqcCqAGuAqwCrwKpAagBrwKwAqkBXwCpAcIBwgGpAcMBxAFfAMIBxQFfAMQBpwFfALECsgKqAscBxQEEAMcBxAHCAQIAswIHALACqAEHALMCqAGnAqICwQEHAKgBrQKnAqgBtAJVAVoBWgE3ALUCUQFVAbYCVQG0ArcCuAJSAbQCtAJSAbcCuQJaAboCugJaAbsCvAK7AloBvQK3AlIBNgC+Ar8CNwA2ALsCuwI2AFIBNgC/AlIBuwK1AjcAUgG4ArsCwALBAr8CwgLDAr8CxALFAlIBxQIUAVIBYQFiAcYCYgFuAHAAwAJiAccCYgFwAMgCyAJwANUAcACEANUAyQJiAcACygLFAtUA1QDFAsgCwwLCAsgCxwLBAsACvgI2AMYCxgI2AGEBYgEwAMsCMABiATEAYgHLAswCnQHNAi8AVwHOAp0BzgLPAp0BzALLAs4CzgLLAs8CywIwAM0CzQIwAC8AlQLQAokBiQHQAogB0AJOAIgBTgBJAEwAQwDRAkQATwBQAMABUADSAsABwAHSAqYB0gLTAqYBpgHTApUC0wLQApUCLwAuAIACgAIuAC0A1AJfAV4BXgGaAdQCCgIzAJoBmgEzANQCNQDVAh4CHgLVAhUC1QIzABUC1gLXAtgC2QLaAtsC2QLcAt0C1wLWAt4C3wLgAuEC4gLjAuQC4wLlAuQC5gLnAugC6QLmAuoC6gLmAusC7ALtAu4C7gLtAu8C8ALxAvIC8gLxAukC8wL0AvUC9gL3AvgC+QL6AvsC+AL3AvwC+gL8AvsC/QL+Av8CAAMBAwIDAwMEAwUDBgMFAwQDAQMAAwcD/QL/AggDCQMKAwsDDAMJAwsDDQMOAw8DEAMPAw4DEQMSAxMDFAMVAxYDFAMXAxUDGAMZAxoDGgMbAxgDHAMdAx4DHQMcAx8DIAMhAyIDIwMkAyUDIwMmAyQDJwMoAykDKQMqAycDKwMsAy0DLgMvAzADMQMyAzADMwM0AzUDMAM2AzEDNgM3AzEDOAM3AzYDMwM5AzQDLwMuAzoDOwM8Az0DPgM/A0ADPAM7A0EDQgNDA0QDRQNGA0cDRANDA0gDGAFFA0cDSQNKA0sDSwNKA0wDTQNOA08DTwNOA1ADUQNSA1MDVANVA1YDVwNYA1kDUgNRA1oDVQNUA/IAWQNbA1cDXANdA14DXwNeA10DYANhA2IDYgNjA2ADZANlA2YDZgNnA2QDZANoA2kDaQNoA2oDawNsA20DbgNvA3ADcQNtA2wDbgNyA28DPAFzA0cBdAN1A3YDdgN1A3cDeAN5A3oDewN8A30DfQN+A3sDeQN4A38DgAOBA4IDgwOEA4UDhAOGA4UDhwOIA4kDiQOIA4oDiAOLA4oDjAOKA40DigOLA40DjgONA48DkAORA5IDkwOUAygBKAElAZMDlQOWA5cDlgOYA5cDmQOaA5YDmgObA5YDnAOdA54DnwOgA6EDogOgA6MDowOgA6QDnQOlA54D",count:908},{rgb:[1,1,1],positions:"o/8oBPn7qP8uBBv8cf8YBMb7gP/jA5D6tf/uA4X6uP/oA4H6cf/XA1z6rP9PBNP8kf9OBOH8rv9WBPf8d/9JBNf8gf9MBOX8cf9RBAv9dP9VBAH9hv9JBM/8lv9TBPj8gP9QBPj8sf9IBKT8sP9QBLr8lf9IBLz8cf89BJv8uP9CBH38gP8rBCX8cf8hBPj7tv8gBMD7pf8DBAn7cf8ABDz7tP8FBCP7hv/9Ax/7m///AxX7j//5A/36s//cAz/6uP/sA5b6l//uA7j6nf/sA6j6pf/jA1n60AAFBTYAoQDjBOgAEgHRBEgAAv/pBCcAOv/dBLUANP/uBKUAzv7IBPj/hwAOBcL/PQAXBW8AFgAIBdkADQHNBJn/KADmBBIBPf8CBfz/l/8HBZoAOP+PBID+UP9sBAb+2f60BHr/pQBmBOv9ZgBdBIz9vACWBI3+0/9YBFH9mv9cBIv9kf/yBGT/DwGnBCn/PADFAxr6jQDKA4P6mABLBGD9zP/DAxr6JwCHAxv5zP+HAyD5lf+RA135cgCWA3X5TACIAyr5zQFVA4n/XQGfAKj+rgG/Ajb/eAGFAt7+X/+iAEr+ZACjAif+gf6eAOn+dP61AvH+F/60AOj/Of5aA3r/If4xA/f/If6eAPf/Jf4ZA0MAMf4GA3sAFP6uABUAGP+eAMYBk/7KAjgBFP+lAqkBof+UAt8BfACXAtYB3ACeAMEBMwG2AnYB1gGeAJcArwHpAtYA3QEhAycAvACxAsz3OwDEAsj3tgDNAvr3+f+7ArP3rf95AlL3CQKwAKv2xgE8AeP15wEHAaH2wAFUAcz2/gDtAeL1GAJkANX29wD5AWj2VwG8AYf2GQJ9AOL1IQAlAuf1uwAqAsz2XQF0AkD49QDYAjv4HwHrAqT4SAHXAhf5qgGPAcr4YgGTAoj5fQHtAZ73PQEfAmn3tQB2Anv3MABpAiz3LgERA4D5NgETA0D7OwHuAuv6RQHZAmv6ZwE7Asv5ugAQ/o33BwFH/sz30QBB/gb4RwFx/s33TwDm/e/2zQAJ/ir38//k/QL3xAF3/2b4rgEb/zn41QGk/2P44wEi/2r3hQGr/sT3iAG4/u73ZgHh/lb4+//V/eT16gAK/ur1lwDt/e/1JgEw/uL1aQFf/uX1egFs/un22wHl/p72GgDZ/RL20AHV/uP1GAJ2/+b1AAIy/4D2jQGG/i/3QwFI/i73oQD1/eD2HwDc/YD2JwIAAP/1GwLA/+b2BAJf/xD3BgLu/6n3+wHtABL3eQHAARj39AH0AFv39AFnAPL3zwErAJv4FAAD/sT3AAAsAlX2HgA7Aqr2ugHjANr48v7hAeP1mv8cAuz1Zf5yAeP1//3NAOL11/0mAOX1Jv7h/uL16/1s/+P1zv4w/uj1a/6D/uP1ev/j/eP1u//c/T32cv/LAu338f52AsX38P7hAmv41v1qAIb2yv7NAS32Wv51AcT2IP4qAcv29/4XAv32Xf+AAn73hv9GAur2dv8qApX2mf6xAYz2KP8TAqj21v70Atb4wv7yAqf6yv4TA0D7yv7vAgf7rP61AuL4qP6XAvT5rv8C/rD3tv50/tX3aP8b/s33KP9B/vv3EP8P/tz2RP/5/aX2mf5h/jD3MP8X/nP32P4l/pX24/4x/kD3Ef40/4L3Bv4S/w73Vv6R/sj2Cf4i/9b2Zf7CAYz3LP4/AZD3qP7mAR/3AP61AFr38P2SAMz25v0GAA73LP5h/yj4Lf69/2/4+f1EAJz3ev6b/o/3Of6RALn4hP7xAYn5Yf7n/gX4NQEGA0L7TQAt/hv4wQH7/6j4KgGF/hf4ewF3AWz5bQCz/q74ewHl//H42wCd/zX5ZwDq/uD42/8+/j34qQDnALz5QAEWAgD6WAB6/zL5n/8I//H4zQBuAtD6rwCKAi/7GwBlAtf6gf8/Apz62//SAT36hv8qAdv5lf+t/0z5vQDqATr67v/dAhz9Y/+bAoj7S/9wAuD6b/+TAQv6zP+A/oz4zv67/mj4wf4+/8D4Sf6X/5L4+/6p/yX5sv4kACP5Qf9J/wP5PQGFAl36CQFPAmT65QCYAh77BwGvAhj7bv4rAOz4Iv91AeX5p/6QAaP5y/4GA0L7xv6zApT6rf5HAgv66f50ApX67P7rARf6OP+UAj77BP+oAiX71/6nA9j80/7BA6b9yv50A5/9wf6FAwH+sv6xA0r+lP5jA6H+yv4TA0D7y/4GA0L7Lf8MA+393f5HA5j94P48A8b9xP5jAwz+0/6mAon+pP4bA4j+1P5LA/T94v4PA0H+dwD6AtD9MQD3Aq/97f/zAsP9M/+uAkz+m//IAiX++v4mA+39FgDeAvv9BwGCAnL+MgFjA5P9HAEsAw/+AwEmA8b92AAIA6P91QAGAwn+JgHLAnb+QgEEA3H+YwEvA47+RAFwAxr+MgFjA5P9OQGnA+39TwGxA1L+NgETA0D7KQGyAxr9",indices:"AAABAAIAAwAEAAUABQAEAAYABwAIAAkABwAKAAgACAAKAAsADAAJAA0ACgAHAA4ACgAMAAsACwAMAA0ACQAPAA0ADQAPABAADQAQAAsACAAPAAkAEQASABMAFAATABIAFQAUABEAFAASABEAFgABABcAFwABAAAAAgABABgAGQAaABsAHAAaABkAHAAZAB0AHQAZAB4AHgAZABsAHwAEACAABAAhACAAIAAhACIABgAEACMAAwAhAAQAIwAEAB8ABgAjAB8AJAAlACYAJwAoACkAJwAqACgAJAArACwAJAAsAC0AJQAkAC0AJAAmAC4AKAAvAC0ALQAwADEAMgAzADQAMgA0ADAANQA2ADcANgA4ADcAOAA5ADIAMgA5ADMAKQAoAC0AOgAwACsAKwAwACwALAAwAC0ALQAvACUALQAxACkAKQAxADAAKQAwACcAOwA1ADcANwA4ACsAKwA4ADIAMAA0ACoAJgA7AC4AOwA3AC4ALgA3ACQAJAA3ACsAKwAyADoAOgAyADAAMAAqACcAPAA2AD0APQA2AD4APAA/ADgAQAA/ADwAPwBBAEIAQABBAD8AQwBEAEAAPAA9AEAAQAA9AEMAPAA4ADYANgA1AD4ARQBGAEcARgBIAEcASQBKAEYASwBMAEkATQBMAEsATgBNAE8ATQBQAE8AUQBPAFAAUgBRAFMAUwBRAFAAUwBUAFUAUwBVAFIAVABWAFUAVABXAFYAWABXAFQAVABZAFgAWQBaAFgAWQBbAFoAWwBcAFoAWwBdAFwARgBFAF0ARgBdAFsAXgBfAGAAXgBhAF8AYgBhAF4AYwBkAGUAZQBkAGYAZABnAGYAZgBoAGMAZwBpAGoAZwBqAGYAZQBmAGMAYwBrAGQAaQBnAGwAbABtAGkAbgBvAHAAXgBgAG4AbgBgAG8AbgBxAHIAcQBzAHIAdAB1AG4AbgB1AF4AdQB2AF4AdgB3AF4AXgB3AGIAeAB5AHoAcwB7AHwAeAB6AHsAcAB4AHEAcQB4AHsAcABxAG4AcQB7AHMAcwB8AHIAfQB+AH8AfQCAAH4AgQCCAIMAhACFAIYAhQCHAIYAiACJAIoAiwCMAI0AjgCPAIwAkACPAJEAiwCNAJIAjACPAJAAjwCTAJEAkwCUAJUAlQCRAJMAkACWAJcAlwCCAJAAggCBAJgAmACBAJkAkgCNAJkAjQCMAJkAmQCMAJgAmACMAIIAjACQAIIAkACRAJYAlACaAJsAiQCHAIUAhgCcAJ0AaABmAJ4AngBmAJ8AZgBqAJ8AaABrAGMAngCgAJ0AoAChAJ0AnQChAKIAmwCdAJwAnACGAIcAmwBoAJ0AnQBoAJ4AoACeAHQAngCfAHQAdACfAHUAnwBqAHUAdQBqAG0AagBpAG0AowCDAH0AgwCCAH0AggCXAH0AlwCWAH0AfQCWAIAAgACWAIgAiACWAIkAiQCWAIcAlgCRAIcAkQCVAIcAlQCUAIcAhwCUAJwAnACUAJsAmwCaAGgAmgBrAGgAbACkAG0ApAClAG0ApQB3AG0AbQB3AHUAdwB2AHUAdABuAKAAbgByAKAAoAByAKEAoQByAKIAcgCmAKIAmgCUAGsAZwBkAGsAbABnAGsApwCoAGsAqABsAGsAqQCnAGsAawCqAKkAawCrAKoArACtAGsAawCtAKsArgCvAGsAawCvAKwAawCwAK4AjgCMAGsAjACLAGsAawCLALAAkwCPAGsAawCPAI4AlACTAGsATQBLAEkAUwBQAEkASQBQAE0AVABTAEkAWQBUAEkAWwBZAEkASQBGAFsAkgCZALEAbACoAKQAYQCyAF8AYQCzALIAtACyALMAtQCpAKoApwCpALYAtgCoAKcApQCkAKgAtwC4ALkAswBhALoAugBhAGIAdwC7AGIAqAC8AKUAtwC5AL0AvQC5AL4AuQC7AL4AvgC7ALwAvAC7AKUAuwB3AKUAvwDAAMEAwADCAMEAwwDEAMAAvwDDAMAAvwC0AMMAxQCDAKMAxgDHAMgAyQCDAMUAyQDKAIMAywDMAMYAmQDKALEAsQDKAM0AiwCSALEAzADLAM4AywDKAMkAgwDKAJkAmQCBAIMAywDNAMoAywDPANAAzQCwAIsAsQDNAIsAzQDRALAAsADRAK4ArgDRAK8ArwDRANIA0gCsAK8A0gCtAKwAxQDMAMkAzADOAMkAzgDLAMkAywDQAM0AzQDQANEA0ADSANEAtQCqAKsAswDTALQAtADTAMMAwwDTANQAuADVALkA1ADWAMMAqAC2ALwAvAC2AL4AvgC2AL0AtgCpAL0AvQCpALcAqQC1ALcAtwC1ALgAtQDXALgAuADXANgA1wC1ANgA2AC1ANAA2QDaAM8A2gDbAM8A2wDEANYAxgDcAMsA3ADPAMsA0AC1ANIAtQCrANIA0gCrAK0A2gDdANsA3QDeANsA3gDEANsAxADDANYAuwC5AGIAYgC5ALoAuQDVALoAugDVALMAswDVANMA0wDVALgA1ADTANYA0wC4ANYAuADYANYA2ADQANYA1gDQANsA0ADPANsAzwDcANkA2QDcAN8A3wDcAMYAxgDMAMcAxwDMAMUAegB5AOAApgByAHwAhgCdAKIAfwDhAH0AowB9AOEAhgDiAIQAhgCiAOIAigCAAIgAgADjAH4AgACKAOMAhQCKAIkAfADkAKYAfwB+AOMAigB/AOMA5QDhAH8A5gCEAOIAhQCEAOcA5wCEAOYAhQDnAIoA5wDoAIoAigDoAH8A6ADlAH8A5QDoAOEA6QDhAOgA4gCiAOYA6gDnAOsA5wDmAOsA6wDmAOQA5gCiAOQA5ACiAKYA7ADnAOoA7QDoAOwA6ADnAOwA7gDvAPAA8ADxAPIA8gDzAPQA9AD1APIA9gD3APAA7AD0AO0A7ADqAPQA8QDwAPgA9wD4APAA8wDyAPkA+gDoAO0A6QD6AMgAowDhAOkA+gD7AMgA+wD8AP0A/AD+AP0A/QD+AP8A9AD+AAAB6AD6AOkA+gDtAPsA7QD0APsA9AAAAfsA+wAAAfwAAAH+APwAfAB7AAEBfADrAOQAAgEDAe4A7gADAe8AegABAXsAfAABAesAAQF6AOsAAgH1AOoA6gD1APQA6gDrAAIBAgHuAPUA7gDwAPUA9QDwAPIA6wB6AAIBegAEAQIBAgEEAQMB/QDeAN0ABQHeAP0A/gD0AAYB/gAGAf8A/wDeAAUBBQH9AP8A9ADzAAYB/wAHAd4AwgAIAcEA2QD9ANoA3wD9ANkA2gD9AN0AxgD7AN8A+wDGAMgAowDpAMUAxQDpAMgAxQDIAMcA+wD9AN8ACQHCAMAAwADEAAkBxAAKAQkB3gAKAcQA8gDxAAsBBwEKAd4A/wAGAQwB+QDyAAsB+AANAQ4BDQH4APcA+AAOAQsBCwEJAQoBCwEGAfkA+QAGAfMACgEHAQwBDAEHAf8ACwHxAPgABgELAQwBDAELAQoBCwEOAQkBCQEOAcIADwG/AMEADwHBABABEQEQAcEATABNAE4AEgETARABFAETARIBFAFOABMBTABOABQBEAERARIBFQEWAREBDQH3ABcBEQEIARgBCAHCABgBwgAOARgBGAEOARkBGQEOARcBDgENARcBEgERARoBSQBMABsBGwFMABwBFAEcAUwAEQEZARoBGQEdARoBGgEcARIBGgEeARwBHAEUARIBHwEgAfAA8ADvAB8BIAEhAfAA8AAhAfYA9gAXAfcAEQEYARkBGgEdAR4BFwH2ACEBIgEjAUkAHAEeARsBJAEZARcBFwEhASMBIQEgASMBIAEfASMBIwEfASUBSgBJACMBJQFKACMBSQAbASIBIgEbASMBGwEeASMBIwEeARcBHgEdARcBFwEdASQBJAEdARkBJgFGAEoAJwEoASkBKgEpASsBKAErASkBKgErAR8BLAEoAS0BKwFKACUBJgFKACwBSgArASwBLAErASgBKwElAR8BegDgACcBAwEqAe8AKgEfAe8ABAEpAQMBAwEpASoBJwEpAXoAegApAQQBLAFIACYBJgFIAEYALAEtAUgALQEoAS4BKAEvAS4BLwEoATABSAAtAUcARwAtAS4BLwEwATEBLgEvATIBMgEvATEBLgFFAEcALgEyAUUA4AAzATABMAEzATEBNAF5AHgAMQE0ATIBeQA0ATEB",count:523}],link6:[{rgb:[1,1,1],positions:"AAD0Acr/9P/sASMA+//3ASAAxAFj/m7/tAFt/lT/zwFA/mn/7gEs/iv/1AFU/kv/8wG5/mn/7wE6/mH/8gFH/lb/AAIu/1z/0gFp/27/UAF1/mf/tAEf/2r/igHe/mT/MAGC/mj/7QFYAAAAYgFlAQAA1wGLAEr/sAHqAGH/ZAFTAW7/JgGMAW7/0QFW/1b/qADTAXT/twC7AQ0AJwDvAZP/6QEYAGb/5wE6AED/5QHn/03/AwIGACT/QAKo/wAA+QEQALb/KgLO/+7+aQIo//D+ZwI5/wAA8gGE/1X/9gGj/1n/3AGv/1T/iAHS/lT/NAF5/k//jAQE/rP+twRE/uX+BwUC/kn/gAQx/qr+bwSm/sX+RASi/qf+eAMD/kH+xwIr/m3+BgNx/mr+OQQJ/nT+LAUA/v3/EQUh/nP/JgUz/vn/hwIA/oj+YAII/qH+3wMC/lL+wQMy/lL+AQQ3/mX+nQS0/vT+4wRB/iH//QQdAvr/3QRpAu//1gRhAgAAKwMl/5ABAQO7/60BkgKQ/48BDAQG/28BIwSb/48BuQOh/7EBrQQ0/wEBwgSn/xkBmQSc/0IBEgRxAJsBuAMl/40BWgSi/3MBiwSRAsEAwgR9AocAwQRvAnoAEgWDATkAGQVqAfr/AAUbAg4AzwQ/ApwA9QTOAX4AxgRgApUAogRuAtQA7wQdAccAlwThASEBvwTXABsBXQSsAvUASwRyAjMBGAXnAFkAZQGXAv//EAFmAvv/fQAlAv7/4AK3AmoBygLlAk4BogLAAlMBeAIKA/kAMgIZA5YAKwL5As8AVQLhAhMB4gHBArgA3QFxAgYBWAFQAuAAQwEFAiYBmQLmAjkBIADcAQgB5QANAggBoQAjArIAJgJVAjoBOwPKAm8BEAPmAk4BOQL/AV0BwgEkAi4BHAGTAVsBXwKRAXsB7wFeAXQBigOeAnkBNgM1AakBawPYAZsBjgPNAmkBXAASAoUAqv/UAc4AnwGcAqAA4gHfAnIAmwGzAkwACwFWApEAtgGIAtcAewPRAlkB1wHkAvn/QwC9ATYBiwJ6AJABhgCvAUQBEwIbAwEAVgASAiIA+QOIAl8BLAToAWoBrAMNAasB1QMXAoMB+wOyAkoBCwS8AjIBZATmAGkBBQWn/v//6QTL/oMAEwU0/n4AYQQT/0ABIQTj/mUBBQUy//7//QQ6/2AA6QSb/90AigSy/iABNASk/mMBtAOc/pEBeAPg/pABVQOR/pkB5AMf/qgBJAWj/zYAegMh/5MBzgSo/skAawO4/7kB/ATh/vz/DAUH/gAACgUA/qoAYAIH/kEBbwMA/rABBQMA/q8BqgIA/ooBywEA/nD/LgIG/v/+PgIB/r/+7gEA/tQALAIA/iwB4QEH/qgAkgRsAEwB4QLd/oz+jwL8/rX+XwPC/m7+wgO0/nb+1AS7/kX/xAQO/yv/eQKz/sH+nwMa/2/+9QPi/oj+9QQr/5D/LgMx/27+IwKB/gf/oQQw//P+iAO2/0f+OwTu/qf+YgQc/7/+DwRT/3/+5QS3/xP/9ATD/pz/2wKI/oH+FwWj/43/4AO0/1b+YQSp/4/+JgSn/3D+mgSo/73+CgWz/17/KgWo//f/0AFd/qkA4AFX/gAARgF8/h0AUwGC/gAAUAGD/qgAlQGB/gAAmwF//qgAIQQo/pIBDQQA/pMBoQQx/joBUgQS/nkBlwQB/kABzgQY/goBgwMt/rcBxQRtApL/EAFp/ikAJf5uACYANf5vABsBc/78ACIBKv4zABoBqP5bASYAsv5IASEBGP+qAScAP/+xAe0AzP/xASgAwv5PAS0BpP4zASoBfv+uAUIBDAJyAPQB/AEMAP0BgQIBAJ4BbgKS/6MBHQBeAacBLwDgABoCxQDiABwCKgIZAZEBmwGnABoCZQLXAJoBEwIjAZYBsQFSAYYBTQCcAVsBzv6YAJ0BDv8sAOgBW/+qAP0BHP8JAZsBgv8jAcABmf/IAAkCGP9uATgBnf+ZAUYBz/7cAHsBWP6PACMBQf4qACIBj/7Q/30Bvf4rAS0B8P7R/9EB3P+3ACACnwC+/yACkABHABoCVv/q//0BSP9y//oBj/9/AAwCzAAr/yIC6P9B/x0CWgFF/x8CoAFi/xoCUQCLABcCs/9i/xUCxgGG/xUCHAI3AY4BRf6//x8BMP6r/xsBSgIVAZQBAQBg/lEBVv9c/jwBzP9G/ksB2ACG/mwBmgBg/mMBlgGz/oEBgAGQ/nsB5wGy/ocBmP7z/ioBxf6s/iwB9/6J/jMB/f+3AVEBcAKH/5kBegJa/5kBXAIX/5YBHQLe/pABXgIB/5YBK/+B/jcBTP5P/x8BdgLHAJkBygFYAYUB2QHJ/ocBNwGAAXUB8v/8APwBh/+X/wEC7v9f/w4CYP/r//oBsf9x/wcCBgCjABECowACABsCVgB2/xcCjgC0/xoCKABh/xQCkP92AAICa/89APwB4f+gAA0CBAKr/lsBAwKK/jABLwK9/mQBVwLa/nIBNwLb/pEBtwGG/hAB/QF0/hMBzwFt/tgA6AGu/lL/lAGH/uwAlwA//toAjgAx/igAGwF6/jMBMwBP/lcBfP77/iQBGQXtAKz/T/4l/ycAJv6x/yYAFv9Q/icAJ/9Z/tQAwv6I/ikAGwAr/vEANgAc/igA9v8r/uwAlf84/vkA1v8Z/j8AxADf/tYBLwIH/gAADQTXAGr+qQMaAVT+mwQJAcH+6QHXAo//FwIVA6j/RgIy/uT+awLJ/vT+CwDtAbH/VwDoAYD///7P/mEBef+s/o0B3v8c/xICJgDw/vABHwDH/skBcP8S/+EBM/8y/9IB4P5n/60Blf5j/2YB0ASiARz/nAROAgr/1gQHAk7/iATmAdP+ywTVAPb+ZwSjAhv/lwSTAkL/OAS0Aur+WQRMAZn+8wQ3AUr/IgShAsP+agILAsL+4AJDAon+lgIMAYz+0AL6Asv+KgPiAq/+AwPnAqX+nwOuApD+/wNcApf+2AMBAnr+lQIFA+7+OQOnAor+OAOrAWL+cgL0Avf+pgLKAsH+gAKnAs/+bQO2Aov+wQPMAqz+EATlAYr+9QKRAF3+XgNGAEn+OwJoAdj+QgIkAYYBBwC8ATkBdALuAIwB6QGd/2f/NgLu/gT/JAKX/+b+cgI3/8H+GAW6/3kA/wT+/78ALQIYA3f/UwILAz7/pgSDAl//IwIUA6X/GwSzAtn+0APCArf+hQPQAqf+qgL7AuL+fAIEAwn/IQIUA1AAGAIXAwAAAQKz/wn/CALEAAr/TQKu/7b+fAKr/5H+0AKw/2X+DgOq/1T+DAUH/gAAiQMH/qcB2wRWApT/BQWsAaH/QwRuAH/+WgJj/gAAawLG/gAAkwL+AgAB+QO5AjUBSQSpAgQBcAII/4MBhgLL/m8BhQIt/4IB6gFO/toAOgJZ/i4BWQKb/lYBGgOB/pMBlQJ//mUBhAJQ/mAB5gG5ATb/3gG0Am//SQFfApH/0wFpAlD/SAEpAnb/+gAUAoT/sQHTAVL/EAJwAiv/XAH9AWv/FgFqAtX/JAHVAXH/rwAQApT/gAAZArT/XAMEA9P/RgMIA+f/fwP+AtD/aQMBA+7/dgP+AgsAkwP7AiMAmwP5Auv/gQP+Ai8ASAMIAxwAYgMCAwEAXAMEAy0AAAMbA/j/GQMUAwcAHAMTA/z/9gIeAwYAaQMFA1kAeAMQA2YAdwMDA1gAbAMKA34AdgMIA38AxgP1Av3/ywP8AgEA6wPzAvf/ygP1AgkA7gPzAgEAeAMHA4P/dgMRA43/eQMDA6f/bwMJA4D/ZwMGA6P/cAMEA6v/GwCw/xMC+v/z/xACtv/S/wgCJgB//xQCDgCw/xICAgCM/xACSAAiABYCAQA6ABAC6f/z/w4COwBOABUCAABhABACFAA6ABICJwB1ABQC",indices:"AAABAAIAAwAEAAUABgAFAAcACAAJAAoACwAMAAgACAADAAkAAwAIAA0ADQAIAA4ACAAMAA4ADQAPABAABQAJAAMADQAOAA8AEQASABMAEwASABQAFAASABUAFQASABYADgAMABcAFgASABgAEgAZABgAGQABABgAGAABABoAGwAcAB0AGwARABMAHQAeABsAHwAgACEAIQAgAB4AIgAjACEAIwAfACEAIAARABsAJAAiACEAJQAkACEAJQAdACYAIQAdACUAJwAOABcAKAAQACcAJwAPAA4AJwAQAA8ABAAnABcABAAoACcADQAoAAQAKQAqACsALAAtACoAKQAsACoAKQAuACwALwAwADEAMgAuACkAMwA0ADUANAAzACsANgAwAC8ANwAwADYAOAA5ADoAOgAyADgAKgA7ADwAOQA4AC8AKwAqADwAPQA+AD8AQABBAEIAQwBEAEUARgBHAEgARABJAEUAQwBFAEoASwBJAEQATABNAE4ATwBQAFEAUQBSAFMATQBUAFEATQBVAFQAUQBVAFIATwBRAFMAUQA/AE0AVgBXAFgATQBZAFUAVQBRAFQAUgBXAFYAVQBaAFcAUwBSAFYATwBbAFAATwBWAFsAVQBXAFIATwBTAFYAXABdAF4AXwBgAGEAYgBjAGQAZQBkAGYAZwBoAGkAZwBqAGUAawBsAG0AYQBqAGcAZwBuAGEAYABvAHAAYABfAG8AcQBfAG4AXwBhAG4AcgBxAG4AaQBzAHEAcQB0AF8AcwB1AHEAXwB2AG8AdwBfAHQAeAB2AF8AbwB2AHkAcQB1AHQAXwB3AHgAegB7AG0AfAB9AH4AfAB+AH8AdABBAHcAfABmAH0AZgBkAH0AfQBkAGMAegBcAF4AfACAAGYAcABvAIEAggBcAH4AfABoAIAAZQBiAGQAgABoAGcAXAB/AH4AYgBlAGoAawCDAGwAbQBcAHoAfwBcAG0AZwBmAIAAZwBlAGYAdACEAEEAbABpAGgAYgBqAHAAaQBsAIUAcABqAGAAhgCCAH0AcgBnAGkAggB+AH0AbgBnAHIAagBhAGAAbQBoAH8AhwB6AF4AhgB9AGMAfwBoAHwAbABoAG0AcgBpAHEAgQBvAHkAiAB5AHYAWgCIAIkAigB4AHcAWgCJAFcAiwB4AIoAjAB5AIgAiwCKAEkAiQCLAEkAjQCBAHkAjgCJAEkAWgCMAIgAiwB2AHgAjQB5AIwAVwCJAI4AVwCOAFgAWQCMAFoAWQBaAFUAiAB2AIsAWQCNAIwAiACLAIkAjwCQAJEAkgBIAJMAjwCUAJAARgCVAJYAlwCSAJgAmQCaAJsASABDAJMARABDAEsAnACYAJkAlQCQAJ0AlwBGAJIAkACUAJ0AQwBIAEsAmQBKAJoAmABDAJkAmgBKAJ4AQwBKAJkAlwCfAEYAoACeAEUAkwBDAJgAkgBGAEgARQCeAEoAlQBGAJ8AkACVAJ8AmACSAJMAPwBRAD0AlACPAKEAPQBRAFAAjwAzADUAogAzAKMAOAAyACkAKwAzAKIApAClAKYApACmAKcAqAA2AKkAqgA2AKgANwA2AKoAqwCkAKwArQCkAKsAjgBJAEsAdwCgAIoAigCgAEUAjgBLAK4ASQCKAEUAMAA3AK8ANwCwAK8AsQCyADkAswA7ALQANwC1ALAAsgC2ALcAswC0ALgALwCxADkAKgAtADsArwCwALkALAAuAC0ANwC6ALUAOwC7ALQAtwC8AL0ALQC+ADsANACPADUAvQC8AL8AtgC8ALcAvgC7ADsAuwDAALQANADBAI8AsgCxALYAMgA6AC4ALwAxALEAjwDBAKEALQC9AL4ANACzAMEAKwCzADQAvQC/AL4ALQAuAL0APACzACsAMADCADEAsQC5ALYAMQCvALEAwgCvADEAwQC4AKEAOgC3AC4AsQCvALkALgC3AL0AswC4AMEAOgA5ALIAOgCyALcAoQDDAJQAwgAwAK8AuADDAKEAuQC8ALYAOwCzADwAxAC/ALwAxQC+AL8AxQC/AMYAxgC/AMQAxwDAALsAwADIALQAyAC4ALQAyADDALgAuwC+AMUAyQCUAMMAxwC7AMUAyQDDAMgAygDLAK0AzADNAM4AzwDQAM4AzQDPAM4AywDKANAAywDQAM8A0QCcANIA0wDUANUA1gCfAJcA1wClANIA1ACYANEA0QDSANQAnADXANIA1QDWANMA1wCZAJsA1ADSANUAlwCYANQAnACZANcA0QCYAJwA0wCXANQAPwA+ANgAzADOANkA2gDbANwA2gDdANsA3gDcAN8A4ADeAOEA4gDgAOEA4QDfAOMA3gDfAOEA3gDaANwA3wDcAOQA4QDjAOUA5gDnAOgA6QDoAOcA6gDrAOwA7QDuAO8A7QDwAO4A7wDuAOYA8ADsAO4A7ADwAPEA7ADyAOoA8QDyAOwA8wD0APUA9gD1APcA9wD1APgA+QD3APoA8wD1APsA/AD0APMA/AD9APQA+QD2APcA/gD0AP0A/AD7AP8A/gAAAfQA/wD2APkA9gD/APsA9wD4AAEB+wD8APMA+wD1APYAAgHsAAMBBAH1AAUB9QD0AAUBBgH1AAQBBwECAQgB+AD1AAYBAQH4AAYB7ADrAAMB7gAJAQoBAwHrAAsB7AACAQcBBAEFAQwBDQHmAAoB7gDsAAkBCQHsAAcB5gDuAAoBCwHrAAEBDgHxAO0ADwHdABABEQEOAe0AEgETARQBEQHtAO8A/QDdAA8B/QDbAN0A4wD/APkAFQESARYBFwEYARkB/ADbAP0AGgEbARwBHQHyAPEA6AAeAR8BIAEhASIBIwEaARwB/ADcANsAIgEfASAB/AD/ANwAEAEkARoBJQHvAOgA5ADcAP8AHQHlAPoA5QDjAPkADgEmAfEAFwEVARYB5QD5APoAIQEnARkBHQH6APIA8ADtAPEAJQERAe8AHQHxACgB8QAmASgB5gDoAO8A9wABASkBAQHrACkB6gDyAPoA6gD6APcA6gD3ACkBKQHrAOoA6QDnAA0B5gANAecAKgEEAQwBKwEMAQgBLAEEASoBLQEMASsBKgEMAS0BLgELAQEBLwECAQMBMAEIAQIBLwExAQIBMgEIATABKwEIATIBMAECATEBQQCgAHcAQgBBAIQA3wD/AOMA5AD/AN8AMwEBAQYBLAE0AQQBMwE1AQEBNQEuAQEBNAEGAQQBNAEzAQYBqAAFAAYAqgCoAAYANgE3ATgBGQE5AToBGQE4ATkBGQE2ATgBGQE7ATYBOwE8ATcBPQE8ATsBNgE7ATcBGAE7ARkBGAEXARYBBwA+AQYABwAEAD4BFwA+AQQADQAQACgABgA+AboAHgAgABsAIQEZAToBIgEhAToBQgDoAB8BOwHQAD0BzgDQAD8B0AA7AT8BPwE7ARgBQAFBAdkAQgEYARYB2QDOAEIBzgA/AUIBQgE/ARgBQwEWARIBGgEkAUQBGwEaAUQByQDIAEUByQBFAVAAHQAhAB4ARgEkARAB2gBHARABSAFJARsBRAFKARsBSAEbAUoBSwEWAUMBSwFDARIBRgFKAUQBSwESARQBQAFCARYBSwFAARYBRwFGARABQAHZAEIBSwFMAUABFAFNAUsBTAFBAUAB3QDaABABTgEUARMBRgFEASQBTwFNARQBTwEUAU4BTwFLAU0BTAFLAU8BGwFJARwBSQFOARMBSQETASMBTwFOAUgBSQEjARwBSQFIAU4B6QAeAegAGQEnAVABCQEhASABCQEgAQoBCgEgAQ0BHwHpACABJwEhAQkBGQFQARcBIAHpAA0BUQEvADgAogBRASsAUQE2AC8AUQGpADYAKQBRATgAKwBRASkACQEHAVABUAEnAQkBFQEXAVABUgHGAMQAUwHEALwAVAHHAMUAXACCAF0AVQGGAFYBggCGAFUBCwAkAAwACgBXAQgACABXAVgBCwAIAFgBCwBYASIAVwEKAKkAJAALACIAAQAAAFkBGgABAFkBWgEYABoAAAAaAFkBDAAmABcAWwEjAVwBXAESAV0BXgFfAVABCAFeAQcBIwETAVwBEwESAVwBXQFfAQgBCAFfAV4BEgFfAV0BEgEVAV8BXwEVAVABYAFcAV0BXQEIAQwBBwFeAVABYAFhAVwBGgFbAWEBDAFgAV0BXAFhAVsBIwFbARoBYQFgAQUBYgFhAQUB/QAPAf4A9AAAAQUB/gBjAQABBQFgAQwBYgEaAWEBAAFjAWIBYwEaAWIBGgEPARABAAFiAQUB/gAPAWMBGgFjAQ8BZAFlAWYBZwFkAVQBaAHIAMAAaAHAAFQBaQFqAWsBZAFoAVQBZwFUAWwBZAFnAWUBbQFoAWQBawFqAW4BbwFwAXEBcgFzAXQBdQF2AXcBcgF0AXgBeQF6AXABewF8AX0BeQF+AXoBfwF1AX4BfgF3AVMBdgFnAWwBbgFlAWcBgAF2AWwBdQFuAXYBewF4AXwBfAF4AXQBawFuAX8BdAF/AX4BfAF0AXABegF+AVMBdwGAAWwBcQFwAYEBdwFSAVMBfQFwAW8BbgFqAWUBdAF+AXkBfQF8AXABcAF6AYEBbgFnAXYBfwFuAXUBegFTAYIBdwF2AYABfgF1AXcBdwFsAVIBbwFxAYMBdAF5AXABdAFzAX8BdAB1AIQBHQGFAXsAhAGGAXQAhAERAYYBhAB0AIYBhQGDAGsAJQGGAREBgwCFAGwAQgCEAOgAJgFzACgBhAF1ABEBhgElAYQAJQHoAIQAhQEoAYMAKAGFAIMAhQBzAGkAHQEoAYUBJgF1AHMA4QB7AOIAJgEOAXUADgERAXUAcwCFACgB4QDlAHsAewBrAG0A5QAdAXsAewCFAWsAewB6AOIA4gB6AIcAqAAKAAkAqACpAAoAqAAJAAUAAgBeAAAAJQAMACQAhwEmAAwAhwEMACUAJgCHASUA6QAfAR4BugA3AKoABAADAA0ABAAHAAUAPgG1ALoAPgGIAbUAqgAGALoAiAGwALUAFwCIAT4BiQGKAbAAFwCwAIgBFwCJAbAAlADJAJ0AlQCLAZYARgCWAEcAlQCdAIsBlgCLAYwBeAGNAY4BPgBqAdgAagGPAdgAjQGQAY4BjQGGAJABagFpAY8BaQFrAZEBkQFrAZIBawF/AZIBkgF/AZMBkwF/AXMBcwFyAZQBcgF4AZQBeAGVAZQBeAGOAZUBlgGXAYYAmAEXACYAJgCZAZgBJgAdAJkBhwACAAEAXgACAIcAiQEXAJgBmAGaAYkBigGaAZsBuQCcAZ0BigGJAZoBuQCdAbwAnAG5ALAAmwGcAYoBigGcAbAAUQGtAMsAngGjAFEBUQGkAK0AowDVAFEBUQHVAJ8BUQGfAaQAWwCMAYsBVgBYAIwBRwCWAFgAWwCdAMkAWwBWAIwBWACOAK4AiwGdAFsArgBLAEgARwBYAK4ARwCuAEgAjAFYAJYAUABbAMkA1QDSAJ8B0gClAJ8BpQCkAJ8B1gDVAKMAowCfANYA1gCXANMAkQCQAJ8AkQCjADMAMwCPAJEAkQCfAKMAVAHAAMcAPgA9AKABoQE9AFAAZQGgAWYBZAGhAW0BbQFFAcgAagGgAWUBoAE9AKEBZgGhAWQBRQGhAVAAbQGhAUUBbQHIAGgBoAGhAWYBoAFqAT4AogFSAWwBxQBsAVQBxQCiAWwBggGdAYEBxgBSAaIBgQGdAZwBegGCAYEBxQDGAKIBggG8AJ0BUwG8AIIBgwGYAZkBgwGaAZgBgwGbAZoBUwFSAcQAcQGcAZsBgwFxAZsBgQGcAXEBkAGGAJcBywCjAVEBywCkAaMBywAjAKQBzwAjAMsAzwAfACMAzwAgAB8AzQAgAM8AzAARAM0AzQARACAAzAAZABEAGQASABEATgBNAD8AhgBjAJYBlgFjAKUBYwBiAKUBYgBwAKUBgQCNAKYBjQBZAKYBWQCnAaYBpwFZAEwAWQBNAEwARgFIAUoB4ADZAN4A4gDZAOAAhwABAOIATAFPAUgB2gBGAUcB2gBMAUgB2gBIAUYBGQDiAAEAGQDZAOIAGQDMANkA2QBBAUwB2QBMAdoA3gDZANoAqAE5AakBIgGoAaoBOgE5AagBIgE6AagBqgGoAakBqgEfASIB0ADKAKsBqwE9AdAAPAE9AawBNwGtATgBrQGuAakBpwCuAa8BpgCuAacArQCrAMoAOAGpATkB1wCbAK4BygCsAKsBrAGwATwBrgGmANcAqwGsAT0BpgClANcAmgBCAKoBQQBAAKAAqQGaAKoBmgBAAEIArQGpATgBrAGnALABNwGvAa0BrgGbAKkBqQGbAJoAQACeAKAAsAGvATwBrACkAKwBNwE8Aa8BygCrAKwAsAGnAK8BrQGvAa4BqwGsAKwBpACnAKwBmgCeAEAAowGkAVgBqQBRAVcBWAGkASIApAEjACIAUQGjAVcBVwGjAVgBsQETABQAmQEdABwAVQGyAbMBtAG1AbYBsQEUALcBsQGZARMAsQG4AW8BgwGZAbEBmQEbABMAtwEUALkBmQEcABsAggBVAboBVQGzAboBVgGNAVUBjQGyAVUBewGyAY0BtgGzAbQBuwG1AbkBtAG4AbcBsQG3AbgBswGyAbQBtQG7AbYBugFeAF0AswG8AboBfQGyAXsBugG8AVoBWgG9AboBvQFaARoAbwG4AX0BvAG2ARgAggC6AV0AtgG7ARgAtAG3AbUBWgG8ARgAtQG3AbkBGAC7ARYAgwGxAW8BuAG0AbIBXgC6AQAAFgC5ARUAuwG5ARYAswG2AbwBuQEUABUAugG9AQAAAAC9ARoAsgF9AbgBeAF7AY0BjQFWAYYAqgFCAB8BvgG/AcABwAG/AcEBwQHCAcABwAHDAcQBwAHFAcMBwgHFAcABvwHGAcEBxwHIAcIBwQHGAccBxwHGAcgBwgHIAcUByQHKAcsBzAHKAckBzQHOAc8BzQHQAc4BzwHOAdEB0AHRAc4B0gHTAdQB1QHTAdIB1QHWAdMB1AHTAdYB1wHYAdkB1wHaAdgB2wHYAdoB3AHYAdsB2QHYAdwB3QHeAd8B4AHhAeIB4wHkAeUB5gHnAegB6QHnAeYB",count:886},{rgb:[.251,.251,.251],positions:"MgMPA5AA1wIlA1MAbQMLA74A3wIdAzcAnAP8ApgADwTvArD/+APrAqz/DAToAtz/CwToAiYAGwTuArr/xQP0Anr/yQP9Al7/OwMNA2r/+wIYA5X/YgMLAz//+QP0AqAALQTlAiYA2wIeA9f/swIpAwkAzAIjA3gARwIjAywAUwIiA5QAVgIhA24AcgIbA6MAvASDAg8AvwSGAkkAwgSDArT/rwSLAmYAhQStAqsAcQSzAq8AZQS7ArQAOgTaApwAFwTpAnsAUATOArMAhwMEA8EAbAMJA8IATQMOA74AAAMaA6gA3AP0AqYA8QPvAqwAHQTVAuwAFgTXAuUAAgTMAiMBDgTRAv4ANwP4AioBzAIMA/0AoQIVA/EAFQTqApj/LQTlAtz/FwTpAof/MATfAmv/ZAS8Ak3/UwTLAk7/dgS2Akn/nASgAnX/qgSPAo//ugSEAs7/+gIbA1j/lgPmAtL+kAPpAsT+OgP4AtT+BgTTAu3+5wPXAur+EQTTAg3/+QPsAkv/5APzAln/6AIcA7cAxgIRA+0AwQR4AnQAwgL+AiUBMQP2AkIBFATqAmsAegPsAjEB0wRtAvT/ZwPeAlQBtAPPAkwBIgIcA0AAzQIjA4j/BAS/Ai4BNgPnArD+/QLzAr/+yQINAwb/dQIcA1z/XAIRAzn/KQIbA6L/RgIjA87/ZwSsAiL/xQR1Apj/iwIIAwP/yAITAxj/kwIeA1j/ywPKArv+VgSuAvAAkwSXArMAOwIYA48AWwIRA8YAEQPuAkcBpASOAmD/eAPaAqz+EAS9Atn+sADuADICNgCnAW8B2f9cAcEB9//0ACYCtf7HAJEBqP4qAUMBVP6xADABjv9mAacBTP+aAUsBJv8rAakBG/9gAP0Bev5pAH8Buv7u/78BxQG4AB4CxAEfAcsBZAHJAC0CZQFyAYYBCv8KAPgByv+wAVcB2QGAACACRP+mAAcCp//lABoCaALdAKoBSQIeANsBgQIAAKQBdwKYAKYBdP7Z/4EBL/4UACwBOf6k/y8B6P5mATwBNAIeAZsBZQHP/s8B/v9Q/mEB6gG4/pUBtAFU/yUCsAAP/zECFP+a//0BSP5u/zUBTwL8/qwBpf5l/5QBqv4S/28Bd/4M/zEBqf9X/m0BIv/K/p4B8P6V/kABhf8p/xQC5AGU/yACcwJJ/6UB4P8P/yICgP9X/k4BYwAN/y8CJf8iAPEBxf/TAA4CrAGVABgCzgFNABQCmwFg/xoCwAGN/xYCRv+J//kB1P8o/xACCQCuAVIBtf9U/kkBYAIU/54BfQLI/5oBEgLQ/o4BVgGR/ngBMf7u/x0BZv4z/yMBrv7O/isBEP+G/jYBMwBW/lcBI/+DATgBqf4sASoBZ/7SACMBRP6AAB8BewJ2AJoBZgLgAJcBOQIWAZIBsAFZAYMBcQP/AgQAeAP+AhIAfgP9Avv/2wIgA+D/3wImAyAAbgP9At//xwP1AgYA9QP0Ak0A5APzAgEAAwMZA24AjAMFA5wATQMSA2v/9gIbA6T/PwMVA48AmwMEA23/2wP5Ao//5wPzAvb/AwTyAtf/zAP0Avb/1QPzAncAAwTsAisACgTqAu3/WgMJA5gAGgMTA4IAngP8ApYA2AIfAxIAKgMSA3f/5gPwApn/rQP6AnH//wPsAsT/cwMFA2P/SAImAwMASQIuAwgAUgIlA63/cgIfA2P/yAIqA4z/jwIhA1z/qAIvA+3/vQIlA8P/xwIqA3gAxwIjA3sAggInA6QAVwIkA2EAcQIgA5sAxgIiA4b/jAIfA6QAXQTCAq8AZgTHAq8AGAToAnEAMwTgAvz/QATmAvP/HATmAoT/HATsApL/OgTiAm//sgSZAq//bAS6AlL/hwS7Av7/rASgAlgAbgTMAgIAqgSVAmsAgATBAg8AqQSVApT/uQSOAtj/ugSMAhsAWQMSAyD/6AP6Akz/4APkAuf+2AIgAyH/QgMVAzr/OQMEA9z+/QIYA1T/zQIVAyD/zgIQAwf/OgP8Atr+qQPnAtv+CATWAgD/dgMFAzr/3QPzAlb/BQTvAjT/EQTYAhT/DgTiAvEAfgMMA9IAqAPvAiYB5QIkA9IA3wISAwcBSwP6AikB4wP5Aq4AzAIWA+gA8AIYA7gAzwIQA/gACAMYA6kAegMFA8YASwMNA8IA6wPvAq8AEQTZAuMACwTVAv0AvgPlAiEBAgMHAxgBAgByABACgv/5/wAC3f/7/wwCSACTABYCFAA6ABICSAAiABcCWgB4/xgCSQBu/xcCigD9/xoCdP+s//4BYv8oAPoB/wO4Asn+GAIYAwAAfAScAgAAMAISA3v/ZgIIAyH/HgIVA7T/dgPTAloBfgSbAgAAFwISAwAAcgSfAtoAqgSAAqAA",indices:"AAABAAIAAwABAAAAAgAEAAAABQAGAAcACAAJAAcACgAFAAsABgAFAAoABwAJAAUACwAMAAoADQAMAA4ACAAEAA8ACQAIABAAEQABAAMAEgABABEACAAPABAAEwABABIAFAAVABYAFgAVABcAGAAZABoAGAAbABkAHAAbAB0AHQAeABwADwAfACAAHwAhAB4AIgAjACQAIgACACMAAgAlACQAJAAjAAIADwAmACcAIgAmAA8ADwAnACgAKAAnACkAKgAoACsAKAApACsALAAtAC4ALwAFAAkALwAJADAABQAvADEAMgAzADQANAAzADUANQAzADYANwA2ADMANwA4ABgAGAAaADcAOQANAA4AOgA7ADwAOgA9ADsAPgA/AD0APQA6AD4ACwBAAEEAQgAXAC4AQwAuAC0ADwAoACEALgBDAEIADwAEACIAGwAcAEQARQBGAC4AEwAlAAEADwAhAB8AGQAbAEQALAAuAEYAQgAlABMARwAPACAASAAsAEYAGgAZAEkARwAQAA8ASABGAEoASABKAEsAFQAUAEwAAQAlAAIAEgARAE0AKwBLACoASwArAEgALgAXABUAIgAEAAIAKgBOAB4AIQAoACoAHgAhACoAEwAXAEIAMQALAAUAMAAJABAATwA8ADsAUAA8AE8AUQA8AFAAQAAyADQAQAAxADIAUgBTAFQAQQAMAAsAVABVAFIADABBAA4ATABVAFQADQBNABEAPQA1AFYANAA1AD0ANAA9AD8ACwAxAEAAVwA3ABoAWABZAFEANgA3AFcAWgBZAFgAUgBaAFgAQAA0AD8AOQBZAFoAWgANADkAWgBNAA0AOwA9AFsATAAUAFUAWABTAFIATgBcAB4AXABdABwAXQBEABwARABJABkAXgBfABUAXwAuABUALgBfAEUAHgBcABwAYABKAEYAXgAVAEwARQBgAEYATgAqAEsAUABYAFEAVwBhADYASQBXABoAYgBPADsAYQA1ADYAVgA1AGEAVgBjAD0APQBjAFsAYgA7AFsAZABlAGYAZgBnAGQAaABpAGoAawBsAG0AbgBvAHAAcQByAHMAZAB0AGUAaABqAG8AdQBuAHAAdgBsAGsAdwBxAHMAcgB0AGQAeABvAG4AeQBtAHgAaABvAHgAdwB6AHEAewB8AH0AfgB/AIAAawBtAHkAZQB2AGsAbQCBAGkAaQBoAHgAZwBmAGsAbwBqAH8AbwB/AH4AcgCCAHQAbACBAG0AbwB+AHAAZwBrAHkAZQBrAGYAewB9AHoAcwByAGQAcQCCAHIAcQB6AIIAdwB7AHoAbQBpAHgAgwCEAIUAgwCGAIcAhgCDAIUAiAB+AIkAigCGAIUAiABwAH4AiwCIAIkAiwCJAIwAjACJAI0AjgCPAJAAkQCIAI8AiAB1AHAAigCSAIYAewCTAHwAjgCRAI8AkgCKAJMAkACMAI0AjgCUAJEAdwCSAHsAkgCTAHsAhACOAJUAjwCMAJAAjwCIAIsAjwCLAIwAjgCWAJQAfgCAAIkAhwCWAI4AhwCOAIQAhwCEAIMAlwBuAHUAlwB4AG4AmAB4AJcAcwBkAJkAeQB4AJgAdwCZAJoAdwBzAJkAZwB5AJgAZACYAJkAZABnAJgAhwCbAJYAlwB1AIgAnAB3AJoAnQCXAIgAkgB3AJwAhgCbAIcAkQCdAIgAngCdAJEAhgCSAJwAhgCcAJsAlACeAJEAlgCeAJQAlgCbAJ4AdACfAGUAoACEAJUAkACVAI4AgACNAIkAigChAJMAoQCiAJMAhQCjAIoAowChAIoApACjAIUApACFAIQAfwClAIAApQCmAIAAgACmAI0ApgCnAI0ApwCQAI0ApwCoAJAAkACoAJUAqACgAJUAoACpAIQAqQCkAIQAqgCBAGwAqgCrAIEAqwBpAIEAqwCsAGkAaQCsAGoAagCtAH8ArACtAGoArQClAH8AogCuAH0ArgCvAH0AfQCvAHoArwCwAHoAegCwAIIAsAB0AIIAsACxAHQAsQCfAHQAnwB2AGUAnwBsAHYAnwCqAGwAogB8AJMAogB9AHwAsgCzALQAtQC2ALcAuAC5ALoAtwC5ALgAtgC7ALcAtwC7ALwAvQC+ALcAuwC/ALwAwAC3AMEAvgC1ALcAwgC6AMMAwAC9ALcAwQC3AMMAtwC8ALkAwgDDAMQAwwC3AMQAugC5AMMAtwC4AMQAuQDFAMYAuQDGAMcAyAC8AL8AuQDHAMMAyQDIALsAvwC7AMgAyADKALwAygDFALwAuQC8AMUAywC7ALYAvgC9AMwAtQDLALYAzQDOAMEAzwDBAMMAwQDPAM0AwADBAM4AwADQAL0AwADOANAA0ADMAL0AxwDPAMMA0QDSANMA0wDSANQA1QDWANQA1wDYANUA1wDZANoA2ADXANoA2QDXANIA2QDSANsA0gDRANwA3ADdANsA0gDcANsA1gDVAN4A1QDYAN4A1wDVANIA1QDUANIA3wDaANkA2QDbAN8A2wDdAN8A4ADhAOIA4wDiAOQA5ADlAOMA5QDkAOYA5wDmAOQA5ADoAOkA6ADqAOsA7ADqAOgA5ADrAOwA5wDkAOkA5ADsAOgA5wDpAOUA6wDhAO0A4gDhAOQA7gDsAOsA6wDkAOEA6gDuAOsA4ADtAOEA6QDoAO8A8ADoAPEA8ADvAOgA7QDxAOsA6wDxAOgA5gDnAOUA8gDzAPQA9QD2APIA9wDyAPQA9wD1APIA+AD1APkA9QD6APkA9AD7APcA9AD8APsA9wD6APUA/AD0AP0A+gD3APsA+AD2APUA/gD2APgA/gDzAPIA8gD2AP4A/gD/APMA8wD/AAABAAH/AAEB9AABAf0AAAEBAfQA9ADzAAABAgEDAQQBBQEGAQcBBAEDAQUBCAEDAQIBCQEKAQsBDAEKAQUBDQEOAQMBDAEDAQ4BDAEFAQMBCAEPAQMBDwENAQMBBQEKAQkBBQEJAQYBCQELAQYBEAECAREBEAEPAQgBAgEQAQgBBAERAQIBBwEEAQUBBwESAQQBEwEGAQsBBwEGARMBEgERAQQBFAEVARYBFwEYARkBGgEZARsBGQEYARYBHAEXARkBHQEVAR4BHwEgASEBIgEgASMBIAEiASQBJQEmAScBJgEoASkB",count:393},{rgb:[.902,.922,.929],positions:"Hv4//4j/2wE+AGz/ogF0/nH/h/5wAWz/YwGBAWz/0gEA/mz/5gEA/qsAugFj/qcAuAEu/hgAgAF0/hYASgF4/iUAwQED/rz/sv8x/iUAYv5X/yUAeP+mASUAaAAt/iUAowA+/iUAIgF4/iUAwQQA/uoAIAMA/p4AaAIA/sb+pQIA/pz+eQIA/kcBPgIA/g4BFwIA/t0AGQMA/m/+9gQA/n0ACgUA/u3/9AIA/ocBjQIA/lYBBAUA/rr/+QEA/rH/JAQA/pP+gwMA/mb+9AMA/nz+rwQA/hD//wEA/gcABQIA/r4ABgIA/j//cwMA/poBOQQA/mUB/wMA/nwB",indices:"AAABAAIAAwABAAAAAwAEAAEAAgABAAUABgAHAAgABwAJAAgACgAJAAcACAAJAAIABQALAAIACwAIAAIAAgAJAAoADAANAAAADgABAAQADgAEAAMADAAAAAIADwAMAAIAEAAPAAIAEQAQAAIADQAOAAMAAAANAAMAEgATABQAEgAUABUAEwAWABcAEwAXABgAGQASABUAGQAaABIAGwAaABkAHAAdABMAHgAbABkACAAfAAYAIAAhACIAIwAeABkAIwAZACEAIwAhACAAHwALAAUAHwAIAAsAJAATACUAEwAkACYAEwAnABwAEwAoACkAEwApACcACgARAAIA",count:42}],link7:[{rgb:[1,1,1],positions:"ugGm/2YCsQGP/3UCswG+/2ECEAN/AfsC9QJAAecCBAJ9Aa4C/QFkAawCxwExAZcCkgHPAHUChAF2AZYCoQIUAgEDMAJLAugCYwJ8AkgD3wL5AUEDSwKAAhIDPAFEAXoCvwE1AF8CJQOMARwDLwOCAUkDHANeARUDIAN2AQYD1AIYAfMCVAKYAJ8CxAHz/1sCeQKuALwCOwJjAJsC7wEIAGoC6wHj/3ACwQGG/w8DrQF3/w4DugGI/4ICqQF+/5UCowF5/+YCUwKFALsCIAJBAA8DLgJUAM8CHQNgAUoD7QIzAUoDAgINABQDIgJTANoCGQJHADkDQQJ+ALwC5wI5AUYD0QIjAfcCqQIzAlADDANAAVAD5AI3AXoDZgKtAMIC6AGUAcQC+AF8AbQC+wFtAb0CwgEzAaUCOQG5AZcCNAG/AaUCbgGGAaUCkgFeAaYCfQH8AbECkQHCAuQCdwA+ApUCagEOA/UCCAKnAgADtQEHAxcDhAEaAwYDaAH/Aa4CwQCZAXQC9f/uAWsCMwDAAWECjgEsA04DbwEAAsICogHdAcYCmQBWArwCKwHUAvICEwHKAvACtAB9AsQCvP/MAWMCyv+0AWACqf+2AWQCj/+qAXwCawEeAwYDbwEpA1ADLAHsAvICRQAmApMCWgEaAxkDJQHcAgQDMgHsAkoDbAA/Ar0CTgAqAtgCPAAdAhADif/FARQDi/+1AXoCe/+rAZ8Cf/+2AZMCe/+4ARQDef+jARIDIQHcAqQDQAHqAnkDMgHbAqcDPgHoAiMDNwHgAgYDcwA5Ar8CUwAiAtsCSQAcAvkCfwCxAWECWgCoAV4CLwE6AV0CKwFRAV8CdgH4AF4CkQGyAF0CrAGMAF8CIQOjAVIDegEdA7AD9wGRAsQDnwIDArsDiAErA3sDPQKVApcDqAIkAqEDaQEJA78DQwHwAsQDPAFjAbEDTADOAa8Dy/+1Aa8DtQHM/68DpQHrALMD2gFxALQDmgFYAcYDnQAQAsYDBADqAb8D6wCPAscD+AJZAcYDjALZAMUDCQJvAMUDDAHKAq8DVgENA7gDXAEaA6IDMQHsAnoDRQAiAl0Dxf/ZAakDXgA1AqUDl//IAYEDYwA9ArIDif+uAYQDgv+mAXADtf/DAacDfP+2AWIDewA/ArADswBrArADJAHMArQDKwOHAYMDIAN3AaoDIwJDAGMDIwNlAYkDFANXAawD0QIQAbIDDANZAbsDqQGO/4YDwQGm/50D3AIhAaQDKwJQAJcD0wGw/5oDPQJoAK0DQAJ1AMEDpAF8/xEDswF5/1YDpAF+/2YDxwGQ/3ID5AHx/7oDNAJtAKwDwgIUAa8DJQJYAJYD1QInAaMD",indices:"AAABAAIAAwAEAAUABQAEAAYABwAIAAkACgAFAAsADAANAA4ACQAIAA8ADQADAAoADQAKAA4ABgAIAAcABAAIAAYABAAQAAgAAwAFAAoAEQADAA0AEQANABIAEwAUABIAFQAEABMAFgAQAAQAFwAQABYAFgAYABkAFgAZABoAFwAWABoAGQAbABoAEgAUABEAEwAEABQAEQAUAAMAGAAEABUABAADABQAFgAEABgAHAAdAB4AHwAdACAAIQAZABgAGwAiABwAGwAhACMAGwAjACIAGwAZACEAHgAbABwAJAAVABMAJQAVACQAHgAdAB8AGgAbAAAAGgAAABcAHwACAAEAHgAAABsAHgABAAAAHgAfAAEAEwASACQAHAAiACYAJwAoACIAIQApACcAKgArACUADQAMACwAEgANACwAEgAtACQAJQAtAC4AJAAtACUALgAqACUAFQArAC8AJwAiACMAIQAvACkAKwAVACUAGAAVAC8ALwAhABgAJwAjACEAMAAFADEAMgAxAAYABgAzADIABgAHADMANAA1ADYACQA0ADYABwAJADcABwA3ADMAMQAFAAYAMgAwADEABQAwADgAOQA6ADsAPAAOAAoAPQAMAA4APgAOADwAOAALAAUAPAAKAAsACwA/ADkACwA4AD8AOQA/ADQANAAJAA8AOwA8AAsANAAPAEAANABAADkAQQA5AEAAOQBBADoAQABCAEEAPQBDAAwAOQA7AAsAOwA+ADwAPgA9AA4ARAA4AEUAMABFADgAPwA1ADQARgBHAEgASQBGAEgASgBCAEsATABKAEsATABLAE0APgBDAD0ATgBPAEMATgA+ADsAOwBQAE4ASQA6AFEAUQA6AEEAOwBJAFAATgBDAD4AUgBPAE4AUABSAE4ASQA7ADoAUABTAFIAUwBUAFIAUABJAEgAVQBRAFYAUQBVAEkAUQBXAFYAVwBRAFgATwBSAFQASgBBAEIAUQBBAFgATQBZAEwAWgBZAE0ATABZAEoAWwBZAFoASgBbAEEAWQBbAEoAWwBYAEEAWgBcAFsAXABYAFsAXABaAF0AXgBfAGAAXgBhAF8AYgBTAEcARwBTAEgAYgBUAFMAYQBUAGIAVQBGAEkAVQBjAEYAUABIAFMAVQBWAGMAVgBkAGMAVgBlAGQAZQBWAFcAOABEAD8ARAA1AD8AQgBmAGcAZgBoAGcAZgBpAGgAaQBqAGgAaABqAGsAagBsAGsAawAQAAIAbAAQAGsAEAAXAAIAFwAAAAIAQgBnAEsAaQBmAEAAQgBAAGYADwAIAGkAaQAIAGoAagAIAGwACAAQAGwAQAAPAGkAEgAsAG0AbgBvAHAAcQByAAwAcQAMAEMADAByAHMAcgBuAHMAcQBuAHIADABzACwAcwBuAHAAbgB0AG8AdAB1AG8AdgB3AHgAdgB4AHkAegB2AHkAewB6AHkAdgB8AH0AdgB9AHcAfQB+AHcAbwB/AH0AgAB8AIEAbwB9AHwAgABvAHwAgQB8AIIAbwB1AH8AgwCEAIUAhAB1AHQAcQBDAE8AgwB1AIQAbgBxAE8AbgBPAIUAbgCFAIQAdABuAIQAfwB+AH0AXgBPAIYAhgBPAFQATwBeAIUAgwCFAF4AhwCIAIkAigCIAFcAiQCIAIsAVwCIAIcAiwB/AIMAgwB/AHUAjACNAHgAjAB4AI4AfgCIAI4AiAB+AH8AfwCLAIgAjACPAI0AigCPAIwAiACKAI4AjgCKAIwAWACKAFcAjwBdAI0AXQCPAFwAjwBYAFwAigBYAI8AkACDAJEAhgBhAF4AXgCSAIMAXgBgAJIAVABhAIYAgwCSAJEAkACLAIMAkACJAIsAVwCHAGUAkwBzAJQAcACUAHMAbwCAAHAALABzAG0AbQBzAJMAgACUAHAAKACVACIAbQCTABIALQASAJYAEgCTAJYAlgCUAJcAkwCUAJYAmACXAJkAlACZAJcAgACZAJQAewB5AIIAfAB7AIIAfAB2AHoAewB8AHoAmgCbAHkAlwCYAJwAlgCcAC0ALQCcAC4AlgCXAJwAlQCdACYAIgCVACYAnQCeACYAnQCfAJ4AHAAmAJ4AgQCfAJgAoACBAIIAgQCZAIAAoACfAIEAmQCBAJgAoQCiAKMAngCbAJoApACeAJoAmwCeAKUApQCCAHkApQCgAIIAeQCbAKUApACiABwAngCgAKUApAAcAJ4AnwCgAJ4ApACaAKIAmgCjAKIAogChAB0AHACiAB0AnwCmAKcAKACoAJUAqQAuAJwApwCpAJgAmACpAJwAnwCnAJgAnwCdAKYApgCdAKgAlQCoAJ0AdwB+AHgAeAB+AI4A",count:293},{rgb:[.251,.251,.251],positions:"AAJwAcoC8wFQAcAC/gFfAboCwQEmAa0CtwEyAaIC5gGOAcMCvwHDAc4ClQHrAcoC/AF2AaIClgHiAakCZwH+AcgCbwH3AZ8CxgE/AYsCcAGFAacCKgHAAa0CLwGzAaUCPQHLAYwCUgGLAa0CkgBUAisDFQHjApoDEgHaAv4ChQBgApkDRAA1AmADvwCWAqMDIwHwAkcDhwBlAskCXQBGAs8CQgAzAvcCZABJAqQDfQA/ArgCfwBOAsACuAByAqoDJAHSAq4DKwHZApsDUAAfAugCUQAgApADaQAxAq8DMwHhAnkDMQHfAiADIAHPAvkCVAAiAtMCOgHnAn4DGQHGAugCuABvAsECRQAYAlUDQwAXAgQDOgHmAiIDdf6X/jcDhf6G/lsDcv6i/lwDj/56/lQDof5z/mQDlP5//nkDmf50/jYDcP6X/m0Dd/6d/nsDev6a/kUDkv6C/joDgv6S/noDnP54/kMDmf6B/j4DmP6B/jEDov54/k0Dp/5u/lsDlf6F/ngDo/53/mIDof54/noDif6N/oIDmP6I/jsDlv6O/jIDif6X/jsDlP6M/nsDq/56/m4Dn/6C/nMDp/55/lMDqf59/kIDe/6q/kYDe/6l/k8DgP6e/jMDfv6i/mwDdP6u/moDcv6l/nIDcv6j/koDg/6X/jwDdv6k/lQDgv6Y/ncDpP6H/oEDxf6G/ncDu/6u/oID4v7E/iAD//6v/lQD7v6n/jsD9P6l/m0D4v4T/1sDy/74/oID+/75/ngDlf6f/o0Dgf7F/lMDdf66/lsDnf7P/ngDgf61/noDh/6g/ncDvf7M/icDjv6Z/jIDhf6y/jADpf7Z/jsDof70/lgDq/7g/ogDsv7P/oMDxv7A/o4D5P6q/oEDuf52/mgDwP56/koDpP6L/i0D3/6p/jkDqv59/k8D6P6g/lADAP/u/oED+f7B/nkDE//i/lED7f7m/iQDAP/0/jgD7P4J/z0DtP73/joDz/7Z/pQDqv7l/i8DeP6v/kkDkf6V/jkDgP6m/kcDff6p/mkDoP6H/j0Dkv6U/nwDp/6A/m4D2wIoAZ8D4gI1AZYDzgIhAa8DqwL9AKsDMQJpAK8DFwJDADADKQJeAMcCHAJMAIEDWwKgALgCawKvAMUC6AI7ATMDHQJMAOACxgIYAegC1QIoAfYC3wIRAQMDWwJ2AMcCbgKSAKMDTwJuAKUDOQJMAI4DXAKdACcDVAKLAAwDbgKiAO0C6gIdASADTQJvADkD5wIfAY0DWAKSAGgDWwJ9AIsD2AILAaQDMgI/ABQDPgJaAM8CUQJ5AMMCTwJuAKUD",indices:"AAABAAIAAgADAAQAAQADAAIAAAACAAUABgAAAAcAAAAFAAcACAAFAAIACAAHAAUACQAHAAgACQAKAAcACwAKAAkAAgAEAAwAAwANAAQADgAPAA0ADQAPAA4ACwAQAAoACwAJAAgACAACAAwAEAAMAA0ADAAEAA0ADgAQAA0AEAAOAAoAEQANAAMAEQAOAA0AEAALAAgACAAMABAAEgATABQAFQATABIAFQASABYAFwATABUAFAATABgAEgAUABkAFgAaABsAEgAaABYAGQAaABIAFgAcABUAGQAdAB4AFQAfABcAFQAcAB8AEwAgACEAGwAiABYAFgAiACMAFgAjACQAJAAfABwAHwAgABcAEwAlABgAIQAlABMAGAAmABQAGAAlACYAJwAdABkAFAAnABkAGgAeACgAKAAiABsAKQAhACAAKQAlACEAKgArAB0AKQAmACUAIgAsACMAIgAtACwAHwAkACAAKgAdACcALgAmACkALgAnACYAIgAoAC0AKgAnAC4AHQAoAB4AGgAZAB4AKAAbABoAFwAgABMAFgAkABwAJwAUACYALwAwADEAMgAzADQALwAyADAANQAyAC8AMgA0ADAAMAA2ADEAMAA0ADYANQAzADIAMQA2ADcANgA0ADcAOAAvADEAOQAvADgAOgAxADcAOQA1AC8AOwA1ADkANQA7ADMANAA6ADcAPAA9AD4APwBAAEEAQgBAAD8AQgBDAEAAPwBBAD4ARABFAEYARwBIAEkAQgBIAEMARwBDAEgASgBFAEQASgBLAEUASwA9AEUAPwBIAEIASwA+AD0ASgBIAEsASwA/AD4ASAA/AEsASQBIAEoARgBMAE0ARgBFAEwARQBOAEwATwBQAEcAPQBOAEUAUABDAEcAUQBDAFAAUgBMAE4ATQBQAE8ATABSAFAATQBMAFAAUgBTAFQAQABDAFUAPQBTAE4AVABVAEMAPQA8AFMAUQBUAEMAUgBOAFMAUABSAFEAUQBSAFQAVgBXAFgAWQBaAFsAWwBaAFwAXQBeAF8AYABWAFgAYQBiAGMAYgBkAGMAYgBlAGQAZgBnAGgAZgBoAGkAYQBpAGgAagBhAGMAYwBrAGoAaQBhAGoAYwBsAGsAZABsAGMAbQBYAG4AbwBwAFcAcABxAHIAbwBXAFYAcABvAHMAcABuAFcAcQBmAHIAcAB0AG4AcgB0AHAAVwBuAFgAXgB1AF8AdgBfAHUAXwB2AHcAXgB2AHUAdgB4AHcAeAB5AHcAeQB4AHoAegB4AF0AWQB7AHgAewBqAHgAagBdAHgAagBeAF0AfAB2AF4AbgB2AHwAbgBcAHYAXABaAHYAdgBaAHgAWgBZAHgAewBZAH0AWQBmAH0AagBrAF4AXgBrAHwAawBtAHwAewB9AGoAfABtAG4AfQBmAGkAaQBqAH0AWQByAGYAWQBbAHIAWwB0AHIAWwBcAHQAbABtAGsAdABcAG4AWABtAGwAbABgAFgAZQBgAGwAcQBnAGYAZABlAGwAfgBhAGgAYABlAFYAfgBiAGEAaAB/AH4AfgB/AIAAZwB/AGgAcQB/AGcAfgCAAGIAgACBAGIAcQCCAH8AcACCAHEAgQBlAGIAcABzAIIAgwBWAGUAcwBvAIQAhABWAIMAhABvAFYAhQCGAIcAiACFAIcAiQCIAIcAigCLAIwAjQCOAIsAjwCGAIUAkACLAIoAkQCSAI8AjQCRAI4AkQCTAI4AlACOAJMAlQCWAJcAmACZAJoAkwCbAJgAmACaAJMAlACTAJoAmgCZAJQAmACcAJkAmACdAJwAnACeAJ8AnACdAJ4AnwCeAJUAngCdAKAAngCgAJUAoQCUAJkAogCUAKEAmQCcAKEAoQCcAJcAnwCXAJwAlQCXAJ8AnQCYAJsAjwCbAJMAiwCiAKEAlACLAKMAlACiAIsAlACjAI4AowCLAI4AlwCkAIkAlwCMAKEAjACLAKEAlgCVAKAAlgCgAIgAlgCIAIkAlwCJAIwAnQCbAI8AhQCgAJ0AhQCdAI8AkwCRAI8AoACFAIgA",count:256},{rgb:[.898,.918,.929],positions:"xwB1ACoEqgBVACoEyQCEAM0DAgF2ACoEWAEOAcwDogFhANEDmwGaAMoDtQE5AMMDbP6oAMwD6/5QAc0Dhf7cAMoDtgHg/8YDyf43AcQDsv+vAc0DOv+NAcUDMACyAc4D//+3AcgDSv41AMMDTf4PAMwDnACRAdADxQCJAcUDZgCsAcQDKQFDAckD6v/dACsEEQC/AC8EFADgANoD8f/fANwD4f/zANwD+f8UAdQDRgHE/9YDBwHEANYDLAEyAC8EBQGuACoE2gDhACsEaQAvAdUDvwAMASwE1P9CAdYD0/83ASgEM//uAC0ERf8DAdUDIP/lANUD/f6iAC8E0/5rANUD0v5XACgEwP69/9cDyf7B/ygEdP+5/90DWP/v/xsEkf+I/ygElv+N/90Dzv9r/90D7P9f/ykEJABj/90DTQB0/9wDIABj/ygEdACK/ykEeACZ/98DsAAMACwEnQDv/94DtwEoAEQCpwF5AEYCjQHAAEQCOgE2AUQCvACOAUQCPAC0AUQC2/+3AUQCb/+gAUQCFf96ATwClP75AEQCbv62AEYCQ/5IACQCTf4+AEQCSP77/0QCrwCTACoE0QCnACkEwgCVAM0DkACqACoEoQDLAM0DnAA0/yoE0QAy/zAE0gBR/80DkABL/80DKf8w/zAEZ/86/yoEQv89/80DS/9+ADEEbv+2ACsEcf+nAM0DOv+PADAEL/+8AM0Dj/4P/0YCzv6p/gsC+f6f/kQCev9S/jMClf9R/kQCBQBA/ggCfwEf/zwCrAFz/xUCrgGf/0QCaQENASICKwFPAQ0CdgCyARUCbP+nARIC4AB9/jYCPwHN/gkCIwG0/kQCqQGR/wkCuQHz/wkCpQGGAAkC3P+3AQgCyv49AQgCbP7RAA0CZf5Z/wgC2wBz/h4CUv6f/0QClgBg/kYCN//BACcEU//OACcEQf9w/ywEav9c/yoEZ/9f/80DT/9j//wDnwBp/ycE0QBm/zIEswDQACkES/7H/8ADXf54/8ADhv4d/8UD3f62/sUDNP95/sMDiv9Y/sED6P9K/sgDQwBM/scDtwBv/sYD7QCR/swDWQHu/sUDdwEY/8gDogGP/84DmAAlAN4DZQB3ANwD//+hAO4D3P+YANwDiv9rAN8DaP8lAN0DlQA9APgDSwCQABMEZv84AP0DpP+PACwEWQDZ/iwEEgAVASwE7v8VASwEpv/U/ioEUP/r/ygER/+L/ywE2gAf/ykE//6O/yoE3v45ACoEegB0ACwE+/5uACcExgCD/zAErgCl/ysE4v6z/ywE+P5U/yIEa//g/t0DUwDK/goE6wAd/9UDKwGq/ywENgHD/9wDVP/g/tUDSQC+/tkD3v9V/tIDUwHw/tADYf6E/88Du/7i/tADEf+b/tEDXP8wAC0EKAHX/y0ESACLAN0DGgALAdwDnwBv/s8DVP+q/80D9v6Q/80DNv+L/80D3P4xAM0DVv9BAM0DKf95AM0D//5xAM0DS/9kAM0DK/96ACcEJQHo/80DtACN/80DCwGX/80DtAD2/80DHAFBAM0DIQHe/ycE/wCM/yYE",indices:"AAABAAIAAwAAAAIABAAFAAYABgAFAAcACAAJAAoABQALAAcACgAJAAwACQANAA4ADQAPABAACAARABIADwATABQAFQAPABQAFAATABYAFwAYABkAFwAZABoAFwAaABsAGwAaABkAGwAZABwAHQAeAB8AHwAeACAAIAAeACEAHgAiACEAIQAiACMAIgAkACMAIwAkACUAJQAkACYAJAAnACYAJwAoACYAJgAoACkAKQAqACsAKAAqACkAKgAsACsAKwAsAC0ALgAvADAAMQAuADAAMgAxADAAMgAwADMANAAyADMANQA0ADMANQAzADYANQA2ADcAOAA1ADcAOAA3ADkAOgA4ADkAOwA8AAcABwA8AAYAPAA9AAYABgA9AAQAPQA+AAQABAA+ABYAPgA/ABYAFgA/ABQAFAA/ABUAPwBAABUAFQBAAA8AQABBAA8ADwBBABAAEABBAA0AQQBCAA0ADQBCAA4AQgBDAA4ADgBDAAkACQBDAAwAQwBEAAwADABEAAoARABFAAoACgBFAAgACABGABEARQBGAAgARgBHABEARwBIABEASQBKAEsATABJAEsATABLAE0ATgBPAFAATgBQAFEAUgBTAFQAVQBWAFcAWABVAFcAWABXAFkAPAA7AD0AWgBbAFwAWwBdAFwAXQBeAFwAXQBfAF4AYABhAGIAYwBkAD0AZAA+AD0AZQBAAD8AZQBBAEAAQQBmAEIAZwBoAGkAYQBqAGIAagBrAGIAYgBrADsAawBsADsAOwBsAD0AbABjAD0APgBkAD8AZABlAD8AZQBtAEEAbQBmAEEAZgBDAEIAQwBuAG8AbgBDAGYAYABoAGEAXwBwAGYAZgBwAG4AWwBwAF8AcABvAG4AcABGAG8AYQBoAGoAagBoAGsAawBoAGwAbABkAGMAaABkAGwAcQBkAGgAcQBtAGQAZABtAGUAcQBfAG0AXwBmAG0AaABnAHEAXQBbAF8AcABbAFoARwBGAEgASABGAHIARgBwAHIAcgBwAFoARABvAEYAQwBvAEQAaQBzAGcAZwBzAHEAcwBfAHEARQBEAEYAdABYAFkAdQB0AFkAdQBZAFcAVgB1AFcAdgBSAFQAdwB4AFQAUwB3AFQAeQB2AFQAdwB5AHgAegBOAFEATwB7AFAAegBRAFAAewB6AFAASgBNAEsAfABMAE0ASgB8AE0AEQBIAH0ASAByAH0AfQByAH4AfgBaAH8AcgBaAH4AfwBaAIAAWgBcAIAAgABcAIEAXABeAIEAgQBeAIIAggBeAIMAgwBeAIQAXgBfAIQAXwBzAIQAhABzAIUAcwBpAIUAhQBpAIYAhgBpAIcAaQBoAIcAaABgAIcAhwBgAIgAiABgAIkAYABiAIkAiQBiAAsAYgA7AAsACwA7AAcAOACKADUAOgCKADgANQCKADQANAAxADIANAAuADEAigAuADQAiwAuAIoAjAAuAIsAjQAuAIwALgCOAI8ALgCNAI4AOgA5AJAAiwCQAJEAjgCNAIwAjgCMAJIAjwCSAC8AkwBWAFUANwA2AJQAlQAlAJYAIAADAB8ANgAzAJQAlAAzAJcAMACYAJkALwCYADAAdgCZAFIATwBOAJoAFwBWAJMAmQCbAFIAnAArAC0AmgBOAJQAAQCdADkAlgAlABcAngArAJwAJQAmABcAAwBKAAAAIwAYAEwAlwBTAFIAFwAmAFYAMwBTAJcAIABKAAMAMABTADMAIwCVABgAngApACsAAABKAAEASgBJAAEAMAB3AFMAAQBJAJ0ASQBMAJ0AIQBKACAAIQB8AEoAGAAXAJMAnwA3AHoAoAA3AJ8AegA3AE4AdwCZAHYAMACZAHcAIwAlAJUATgA3AJQAnAAtAKEAoAA5ADcATAAYAJ0ALQAsAKIAogAsAFIALACjAFIAUgCjAJcAlwCjAKQApAClAJoAmgClAE8ATwClAKYApQCnAKYApgCnAB8ApwAdAB8ALACoAKMAqACpAKMAowCpAKQApACpAKUApQAdAKcAHgATACIABQAdAIkAKgAIABIAEwAPACIAKAAIACoAJAANACcAqQCoAKoAIgAPACQADQAJACcAJwAJACgABQAeAB0AKAAJAAgAqwClAIYAqwAdAKUABAAeAAUADwANACQApQCpAIYALAASAKwAqACtAK4ABAAWAB4AFgATAB4ALACtAKgAKgASACwALwCvAJgArwAvAJIAkgBVAK8AkgCTAFUAkwCSAIwAjAAYAJMAkQAYAIwAnQAYAJEAnQCRAJAAOQCdAJAAoQAtAFIALQCiAFIAlwCkAJQAlACkAJoATwCmAHsApgAfALAAjwAvAC4AkgCPAI4AkQCMALEAsQCMAIsAiwCRALEAOgCQAIoAigCQAIsAGQCyABwAlQAcALIAFwAbABwAGACVALIAlgAXABwAGACyABkAlQCWABwArgCAAIEAgACtAH8ArQCsAH8AfwCsAH4AiQCrAIgArQAsAKwAqwCJAB0ArAB9AH4AggCuAIEArQCAAK4AEgARAH0AfQCsABIAiACrAIcAhACFALMAggCqAK4AswCqAIQAqQCqALMAhACqAIMAiQALAAUAswCFAIYAqwCGAIcAgwCqAIIAqgCoAK4AqQCzAIYAtAC1ALYAtAC3ALUAuAC3ALQAuQC6ALcAuwC3ALgAuwC5ALcAoQC1ALcAnAChALcAvAC5ALsAngC3ALoAngCcALcAVQC8ALsAVQC7ALgArwBVALgAvACeALoAvAC6ALkAtACYALgAmACvALgAmQC2ALUAmwCZALUAmQCYALQAmQC0ALYAoQCbALUAvQC+AL8AvQDAAL4AvQACAMAAwQACAL0AHwACAMEAHwADAAIAHwDBAL0AwgAfAL0AsADCAL0AsAC9AL8AwwCwAL8AoACfAL4AwwC/AL4AnwDDAL4AAQA5AAIAAgA5AMAAwAA5AL4AOQCgAL4AUgCbAKEAVQBYALwAKQCeALwAWAApALwApgCwAMMAewCmAMMAewDDAJ8AwgCwAB8AdAApAFgAKQB0AHUAJgApAHUAJgB1AFYAeQB3AHYAewCfAHoAIwBMAHwAIQAjAHwAeAB5AFQA",count:388}]},unit:1e-4,joints:[{kind:"fixed",parent:"base",child:"fr3_link0",xyz:[0,0,0],rpy:[0,0,0],axis:[0,0,0]},{kind:"revolute",parent:"fr3_link0",child:"fr3_link1",xyz:[0,0,.333],rpy:[0,0,0],axis:[0,0,1]},{kind:"revolute",parent:"fr3_link1",child:"fr3_link2",xyz:[0,0,0],rpy:[-1.570796326794897,0,0],axis:[0,0,1]},{kind:"revolute",parent:"fr3_link2",child:"fr3_link3",xyz:[0,-.316,0],rpy:[1.570796326794897,0,0],axis:[0,0,1]},{kind:"revolute",parent:"fr3_link3",child:"fr3_link4",xyz:[.0825,0,0],rpy:[1.570796326794897,0,0],axis:[0,0,1]},{kind:"revolute",parent:"fr3_link4",child:"fr3_link5",xyz:[-.0825,.384,0],rpy:[-1.570796326794897,0,0],axis:[0,0,1]},{kind:"revolute",parent:"fr3_link5",child:"fr3_link6",xyz:[0,0,0],rpy:[1.570796326794897,0,0],axis:[0,0,1]},{kind:"revolute",parent:"fr3_link6",child:"fr3_link7",xyz:[.088,0,0],rpy:[1.570796326794897,0,0],axis:[0,0,1]},{kind:"fixed",parent:"fr3_link7",child:"fr3_link8",xyz:[0,0,.107],rpy:[0,0,0],axis:[0,0,0]},{kind:"fixed",parent:"fr3_link8",child:"fr3_hand",xyz:[0,0,0],rpy:[0,0,-.7853981633974483],axis:[0,0,0]},{kind:"fixed",parent:"fr3_hand",child:"fr3_hand_tcp",xyz:[0,0,.1034],rpy:[0,0,0],axis:[0,0,0]},{kind:"prismatic",parent:"fr3_hand",child:"fr3_leftfinger",xyz:[0,0,.0584],rpy:[0,0,0],axis:[0,1,0]},{kind:"prismatic",parent:"fr3_hand",child:"fr3_rightfinger",xyz:[0,0,.0584],rpy:[0,0,3.141592653589793],axis:[0,1,0]}],boxes:[{xyz:[0,.0185,.011],roll:0,size:[.022,.015,.02]},{xyz:[0,.0068,.0022],roll:0,size:[.022,.0088,.0038]},{xyz:[0,.0159,.02835],roll:.5235987755982988,size:[.0175,.007,.0235]},{xyz:[0,.00758,.04525],roll:0,size:[.0175,.0152,.0185]}]};var Ug=Math.cos(35*Math.PI/180),nl=A=>Uint8Array.from(atob(A),t=>t.charCodeAt(0)).buffer;function Rg({positions:A,indices:t}){let e=Float32Array.from(new Int16Array(nl(A)),s=>s*PA.unit),n=new Uint16Array(nl(t)),i=new ke;return i.setAttribute("position",new He(Float32Array.from(Lg(e,n)),3)),i.setAttribute("normal",new He(Ng(e,n),3)),i}function*Lg(A,t){for(let e of t)yield*A.subarray(3*e,3*e+3)}function Ng(A,t){let e=c=>new R().fromArray(A,3*c),n=Array.from({length:A.length/3},()=>[]),i=[];for(let c=0;c<t.length/3;c++){let[a,l,g]=[0,1,2].map(h=>e(t[3*c+h]));i.push(l.sub(a).cross(g.sub(a)));for(let h=0;h<3;h++)n[t[3*c+h]].push(c)}let s=i.map(c=>c.clone().normalize()),r=new Float32Array(3*t.length),o=new R;return t.forEach((c,a)=>{let l=s[Math.floor(a/3)];o.set(0,0,0);for(let g of n[c])s[g].dot(l)>=Ug&&o.add(i[g]);o.normalize().toArray(r,3*a)}),r}var Hg=Object.fromEntries(Object.entries(PA.meshes).map(([A,t])=>[A,t.map(e=>({geometry:Rg(e),material:new tA({color:new It().setRGB(...e.rgb,Ce)})}))])),_r=class{constructor(t){this.root=new Ne,this.root.position.fromArray(t),this.links={[PA.joints[0].parent]:this.root},this.joints=[];for(let e of PA.joints){let n=new Ne;n.position.fromArray(e.xyz),n.rotation.set(...e.rpy,"ZYX");let i=new Ne;n.add(i),this.links[e.parent].add(n),this.links[e.child]=i,e.kind!=="fixed"&&this.joints.push({link:i,axis:new R().fromArray(e.axis),kind:e.kind})}for(let[e,n]of Object.entries(PA.links))for(let i of Hg[n])this.links[e].add(new Fe(i.geometry,i.material))}move(t){this.joints.forEach(({link:e,axis:n,kind:i},s)=>{i==="revolute"?e.quaternion.setFromAxisAngle(n,t[s]):e.position.copy(n).multiplyScalar(t[s])})}};var Og="fr3_hand_tcp",yr=Math.PI/180,Gg=[[.87,.37,.08],[.1,.45,.82]],kg={arm:{rides:!1,target:[-.22,-.45,.32],distance:1.8,azimuth:-45,elevation:16},pads:{rides:!0,target:[0,0,-.006],distance:.22,azimuth:-58,elevation:12},along:{rides:!0,target:[0,0,0],distance:.26,azimuth:180,elevation:4}},Xo=30,zg=.12,Vg=4,qo=2,Yg=30,Jg=18,Wg=.6,Al=8,Zo=class{constructor(t,e){this.scene=new WA,this.world=new Ne,this.scene.add(this.world,new ii(16777215,9080726,1.9));let n=new oi(16777215,2);n.position.set(.42,-.7,.9),this.scene.add(n);let i=new Hn(t,t,t);this.cube=new Fe(i,new tA({color:new It().setRGB(...Gg[e],Ce)})),this.start=new xA(new ti(i),new $n),this.start.scale.setScalar(1.004),this.grid=new ai(4,20),this.grid.rotation.x=Math.PI/2,this.world.add(this.cube,this.start,this.grid)}place(t,e,n,i,s){t.move(n.joints),this.world.add(t.root);let r=t.links[Og];t.root.updateWorldMatrix(!1,!0);let o=r.matrixWorld.clone().premultiply(this.world.matrixWorld.clone().invert()),c=new Oe().setFromRotationMatrix(o),a=new R(...e.begin.position),l=(h,d,m)=>{h.position.copy(d).applyMatrix4(o),h.quaternion.copy(c).multiply(new Oe(...m).normalize())},g=new R(...n.position);s>=0&&e.inGrasp(s)&&g.sub(a).multiplyScalar(i).add(a),l(this.cube,g,n.quaternion),l(this.start,a,e.begin.quaternion),this.start.visible=s>=0,this.hand=new R().setFromMatrixPosition(o)}},Sr=class{constructor(t,e,n){this.canvas=t,this.redraw=n,this.renderer=new vr({canvas:t,antialias:!1}),this.renderer.setScissorTest(!0),this.camera=new Qe(Xo,1,.02,20),this.camera.up.set(0,0,1),this.panes=[0,1].map(i=>new Zo(e.edge_m,i)),this.robots=this.panes.map(()=>new _r(e.base_m)),this.pixels=Math.min(window.devicePixelRatio,qo),this.frames_ms=[],this.look("pads"),this.#n(),new ResizeObserver(()=>this.redraw()).observe(t.parentElement)}look(t){this.view={...kg[t]},this.redraw()}colour({back:t,lines:e,edges:n}){this.back=new It(t);for(let i of this.panes)i.grid.material.vertexColors=!1,i.grid.material.color=new It(e),i.grid.material.needsUpdate=!0,i.start.material.color=new It(n)}draw(t,e,n,i,s){s&&this.#e(s);let{clientWidth:r,clientHeight:o}=this.canvas.parentElement;this.#t(r,o,s?this.pixels:qo);let c=r/t.length;this.camera.aspect=c/o,this.camera.fov=this.camera.aspect<1?2*Math.atan(Math.tan(Xo/2*yr)/this.camera.aspect)/yr:Xo,this.camera.updateProjectionMatrix();let{target:a,distance:l,azimuth:g,elevation:h,rides:d}=this.view,m=new R(...a),[C,f]=[g*yr,h*yr];this.camera.position.set(Math.cos(f)*Math.cos(C),Math.cos(f)*Math.sin(C),Math.sin(f)).multiplyScalar(l).add(m),this.camera.lookAt(m),t.forEach((u,E)=>{let _=this.panes[E];_.world.position.set(0,0,0),_.world.updateMatrixWorld(),_.place(this.robots[E],u,e[E],n,i),d&&_.world.position.copy(_.hand).negate(),_.scene.background=this.back,this.renderer.setViewport(E*c,0,c,o),this.renderer.setScissor(E*c,0,c,o),this.renderer.render(_.scene,this.camera)})}#t(t,e,n){let i=[t,e,n].join();i!==this.size&&(this.size=i,this.renderer.setDrawingBufferSize(t,e,n))}#e(t){if(this.frames_ms.push(t),this.frames_ms.length<Al)return;let e=this.frames_ms.reduce((n,i)=>n+i)/Al;e>Yg&&(this.pixels=Math.max(.8*this.pixels,Wg)),e<Jg&&(this.pixels=Math.min(1.25*this.pixels,window.devicePixelRatio,qo)),this.frames_ms=[]}turn(t,e,n){let{view:i}=this;i.azimuth-=t,i.elevation=Math.min(Math.max(i.elevation+e,-20),85),i.distance=Math.min(Math.max(i.distance*n,zg),Vg),this.redraw()}#n(){let t=new Map,{canvas:e}=this;e.addEventListener("pointerdown",n=>{e.setPointerCapture(n.pointerId),t.set(n.pointerId,n)}),e.addEventListener("pointermove",n=>{let i=t.get(n.pointerId);if(!i)return;let s=[...t.values()].find(({pointerId:r})=>r!==n.pointerId);if(t.set(n.pointerId,n),s){let r=o=>Math.hypot(o.clientX-s.clientX,o.clientY-s.clientY);this.turn(0,0,r(i)/Math.max(r(n),1))}else this.turn(.4*(n.clientX-i.clientX),.4*(n.clientY-i.clientY),1)});for(let n of["pointerup","pointercancel"])e.addEventListener(n,i=>t.delete(i.pointerId));e.addEventListener("keydown",n=>{let i={ArrowLeft:[-5,0,1],ArrowRight:[5,0,1],ArrowUp:[0,5,1],ArrowDown:[0,-5,1],"+":[0,0,.9],"-":[0,0,1.1]}[n.key];i&&(n.preventDefault(),n.stopPropagation(),this.turn(...i))})}};function il(A){let t=A[0]+A[4]+A[8];if(t>0){let o=2*Math.sqrt(t+1);return[o/4,(A[7]-A[5])/o,(A[2]-A[6])/o,(A[3]-A[1])/o]}let e=A[0]>A[4]&&A[0]>A[8]?0:A[4]>A[8]?1:2,[n,i]=[(e+1)%3,(e+2)%3],s=2*Math.sqrt(1+A[4*e]-A[4*n]-A[4*i]),r=[(A[3*i+n]-A[3*n+i])/s,0,0,0];return r[1+e]=s/4,r[1+n]=(A[3*n+e]+A[3*e+n])/s,r[1+i]=(A[3*i+e]+A[3*e+i])/s,r}function Kg([A,t,e,n],[i,s,r,o]){return[A*s-t*i-e*o+n*r,A*r+t*o-e*i-n*s,A*o-t*r+e*s-n*i,A*i+t*s+e*r+n*o]}function Ow(A,t){let e,n=new Sr(A.querySelector("canvas"),t,()=>e&&r()),i=o=>{A.style.color=`var(${o})`;let{color:c}=getComputedStyle(A);return A.style.color="",c};n.colour({back:i("--panel"),lines:i("--faint"),edges:i("--ink")});let s=o=>({joints:o.joints,position:o.position,quaternion:Kg(il(o.matrix),o.turn)}),r=()=>n.draw([{begin:e.begin,inGrasp:()=>!0}],[e.state],1,e.time,0);return{show(o,c,a,l){e={state:s(o),begin:s(c),time:a};let g=l/t.edge_m;n.panes[0].cube.scale.setScalar(g),n.panes[0].start.scale.setScalar(1.004*g),r()}}}export{Ow as open};
